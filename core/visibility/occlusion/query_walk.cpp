#include "core/visibility/occlusion/query_walk.h"

#include <algorithm>
#include <utility>

#include "core/visibility/occlusion/node_walk.h"

namespace cullscope::occlusion {
namespace {

enum class Answer : uint8_t { Unknown, Visible, Hidden };

constexpr NodeWalkLines kQueryLines{uint8_t(QueryLine::Frustum), uint8_t(QueryLine::Outside),  uint8_t(QueryLine::Unasked),
                                    uint8_t(QueryLine::Hidden),  uint8_t(QueryLine::Children), uint8_t(QueryLine::Draw)};

/// A node about whose box OpenGL is asked.
struct Question {
    NodeEntry entry;
    GrownBox box;
};

class QueryWalk : private NodeWalk {
public:
    QueryWalk(const InstanceOctree& octree, FrameContext& frame, const QueryOptions& options, std::deque<AskedFrame>& past)
        : NodeWalk(octree, frame, kQueryLines), m_nodes(octree.nodes().size()), m_options(options), m_past(past) {}

    QueryCounters run() {
        takeAnswers();
        if (m_nodes > 0) m_stack.emplace_back();
        while (!m_stack.empty()) {
            std::vector<Question> questions = nextQuestions();
            drawGathered();
            if (!questions.empty()) ask(std::move(questions));
        }
        drawGathered();
        remember();
        countVisited();
        return m_counters;
    }

private:
    /// The answers of the frame that is as old as the latency.
    void takeAnswers() {
        if (m_options.latency == 0) return;
        m_known.assign(m_nodes, Answer::Unknown);
        if (m_past.size() < m_options.latency) return;
        for (const AskedNodes& asked : m_past[m_past.size() - m_options.latency]) {
            worked(kStepsOfAnAnswer * asked.nodes.size());
            const std::optional<std::vector<uint32_t>> hits = frame().answer(*asked.ticket);
            if (!hits) continue;
            for (const uint32_t number : asked.nodes) m_known[number] = Answer::Hidden;
            for (const uint32_t hit : *hits) m_known[asked.nodes[hit]] = Answer::Visible;
        }
    }

    /// Keeps this frame's questions for those that use their answers. A frame that is stopped before leaves the memory as it was.
    void remember() {
        if (m_options.latency == 0) return m_past.clear();
        m_past.push_back(std::move(m_asked));
        while (m_past.size() > m_options.latency) m_past.pop_front();
    }

    /// Visits the next nodes, nearest first, until so many have to be asked about as a batch has.
    std::vector<Question> nextQuestions() {
        std::vector<Question> questions;
        while (!m_stack.empty() && questions.size() < m_batch) {
            NodeEntry entry = m_stack.back();
            m_stack.pop_back();
            visited();
            const std::optional<GrownBox> box = boxInFrustum(entry);
            if (!box) continue;
            if (!visibleUnasked(entry.node, *box) && (m_options.inner || node(entry.node).leaf()))
                questions.push_back({entry, *box});
            else
                goOn(entry);
        }
        return questions;
    }

    void ask(std::vector<Question> questions) {
        worked(kStepsOfAQuestion * questions.size());
        std::vector<EyeBox> boxes;
        for (const Question& question : questions) boxes.push_back(question.box.box);
        m_counters.asked += boxes.size();
        ++m_counters.batches;
        m_batch = std::min(2 * m_batch, m_options.batch);
        std::vector<Answer> answers(boxes.size(), Answer::Hidden);
        if (m_options.latency == 0) {
            for (const uint32_t hit : frame().visibleBoxes(std::move(boxes), BoxQuestion::DepthSoFar))
                answers[hit] = Answer::Visible;
        } else {
            AskedNodes asked{frame().ask(std::move(boxes), BoxQuestion::DepthSoFar), {}};
            for (size_t i = 0; i < questions.size(); ++i) {
                asked.nodes.push_back(questions[i].entry.node);
                answers[i] = m_known[asked.nodes.back()];
            }
            m_asked.push_back(std::move(asked));
        }
        // Depth first: the parts of the first visible node are the next that are visited.
        const size_t bottom = m_stack.size();
        for (size_t i = 0; i < questions.size(); ++i) {
            const uint32_t number = questions[i].entry.node;
            if (recording()) say(number, atLine(QueryLine::Ask, answered(number, questions[i].box.growth, answers[i])));
            if (answers[i] == Answer::Hidden) {
                ++m_counters.hidden;
                leaveOut(number, uint8_t(QueryLine::Hidden), Cause::Hidden);
                continue;
            }
            const size_t top = m_stack.size();
            goOn(questions[i].entry);
            std::rotate(m_stack.begin() + std::ptrdiff_t(bottom), m_stack.begin() + std::ptrdiff_t(top), m_stack.end());
        }
    }

    /// With a visible node: with its parts, or its objects.
    void goOn(const NodeEntry& entry) {
        if (node(entry.node).leaf())
            gather(entry.node);
        else
            pushParts(entry);
    }

    /// The parts of a node, the nearest one on top.
    void pushParts(const NodeEntry& entry) {
        const Node& whole = node(entry.node);
        std::vector<std::pair<Nearness, uint32_t>> parts;
        for (uint32_t child = whole.firstChild; child < whole.firstChild + whole.childCount; ++child)
            parts.emplace_back(nearness(child), child);
        std::ranges::stable_sort(parts, [](const auto& a, const auto& b) { return a.first > b.first; });
        for (const auto& [near, child] : parts) m_stack.push_back({child, entry.planes});
    }

    /// What OpenGL answered: its operands are the latency in frames, and the growth.
    [[nodiscard]] Decision answered(uint32_t number, double growth, Answer answer) const {
        const bool visible = answer != Answer::Hidden;
        const char* sentence = nullptr;
        if (m_options.latency == 0)
            sentence = visible ? CULLSCOPE_TR("OpenGL was asked about its box, grown by %2: it shows before what is drawn.")
                               : CULLSCOPE_TR("OpenGL was asked about its box, grown by %2: what is drawn hides all of it.");
        else if (answer == Answer::Unknown)
            sentence = CULLSCOPE_TR("Its box was not asked about %1 frames ago: it counts as visible, and is asked about now.");
        else
            sentence =
                visible ? CULLSCOPE_TR("Its box, grown by %2, is asked about; %1 frames ago the answer was that it shows.")
                        : CULLSCOPE_TR("Its box, grown by %2, is asked about; %1 frames ago the answer was that it is hidden.");
        return result(number, visible, sentence, {double(m_options.latency), growth});
    }

    size_t m_nodes;  ///< of the octree
    QueryOptions m_options;
    std::deque<AskedFrame>& m_past;
    size_t m_batch = 1;              ///< boxes that the next batch has at most
    std::vector<Answer> m_known;     ///< by node, of the frame whose answers are used; at latency 0 empty
    AskedFrame m_asked;              ///< in this frame
    std::vector<NodeEntry> m_stack;  ///< the next one is the last
    QueryCounters m_counters;
};

}  // namespace

QueryCounters walkByQueries(const InstanceOctree& octree, FrameContext& frame, const QueryOptions& options,
                            std::deque<AskedFrame>& past) {
    return QueryWalk(octree, frame, options, past).run();
}

}  // namespace cullscope::occlusion
