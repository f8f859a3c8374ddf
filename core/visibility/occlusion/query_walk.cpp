#include "core/visibility/occlusion/query_walk.h"

#include <algorithm>
#include <array>

#include "core/base/work_check.h"
#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope::occlusion {
namespace {

constexpr uint32_t kPlanes = 6;
constexpr uint32_t kAllPlanes = (1u << kPlanes) - 1;

enum class Answer : uint8_t { Unknown, Visible, Hidden };

/// A node that the walk has still to visit.
struct Entry {
    uint32_t node = 0;
    uint32_t planes = kAllPlanes;  ///< bit p: FrustumPlane p may cut it
};

/// A node about whose box OpenGL is asked.
struct Question {
    Entry entry;
    EyeBox box;           ///< grown
    double growth = 0.0;  ///< of each side, world units
};

/// The nodes in which the decision about the next one lies. Decisions about nested subjects follow those about what contains
/// them; after a batch the walk goes on in a node that was decided before others, which is then said again.
struct OpenNode {
    uint32_t node = 0;
    bool parts = false;  ///< it was said that its parts are visited
};

class QueryWalk {
public:
    QueryWalk(const InstanceOctree& octree, FrameContext& frame, const QueryOptions& options, std::deque<AskedFrame>& past)
        : m_octree(octree),
          m_frame(frame),
          m_frustum(frame.view().frustum()),
          m_eye(frame.view().eye()),
          m_recording(frame.recording()),
          m_options(options),
          m_past(past),
          m_progress{nullptr, frame.stop()},
          m_work(m_progress) {}

    QueryCounters run() {
        takeAnswers();
        if (!m_octree.nodes().empty()) m_stack.push_back({0, kAllPlanes});
        while (!m_stack.empty()) {
            std::vector<Question> questions = nextQuestions();
            drawGathered();
            if (!questions.empty()) ask(std::move(questions));
        }
        drawGathered();
        remember();
        m_frame.counters().nodesVisited = m_counters.visited;
        m_frame.counters().bytesTouched = m_counters.visited * sizeof(Node);
        return m_counters;
    }

private:
    using Node = InstanceOctree::Node;

    [[nodiscard]] const Node& node(uint32_t number) const { return m_octree.nodes()[number]; }

    /// A box that is drawn for its question takes as long as this many steps (work_check.h), its answer as long as these.
    static constexpr size_t kStepsOfAQuestion = 64, kStepsOfAnAnswer = 4;
    void worked(size_t steps) {
        for (size_t step = 0; step < steps; ++step) m_work.step();
    }

    /// The answers of the frame that is as old as the latency.
    void takeAnswers() {
        if (m_options.latency == 0) return;
        m_known.assign(m_octree.nodes().size(), Answer::Unknown);
        if (m_past.size() < m_options.latency) return;
        for (const AskedNodes& asked : m_past[m_past.size() - m_options.latency]) {
            worked(kStepsOfAnAnswer * asked.nodes.size());
            const std::optional<std::vector<uint32_t>> hits = m_frame.answer(*asked.ticket);
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
            Entry entry = m_stack.back();
            m_stack.pop_back();
            ++m_counters.visited;
            m_work.step();
            const EyeBox box = relativeToEye(node(entry.node).box, m_eye);
            const double margin = marginFromEye(node(entry.node).box.centre(), box.centre, glm::length(box.halfExtent), m_eye);
            if (!inFrustum(entry, box, margin)) continue;
            const double growth = boxGrowth(box, margin, m_frame.view());
            const EyeBox grown{box.centre, box.halfExtent + Vec3(growth)};
            if (isAsked(entry, grown, growth))
                questions.push_back({entry, grown, growth});
            else
                goOn(entry);
        }
        return questions;
    }

    bool inFrustum(Entry& entry, const EyeBox& box, double margin) {
        const Subject subject = Subject::ofNode(entry.node);
        bool outside = false;
        const uint32_t planes = entry.planes;
        for (uint32_t p = 0; p < kPlanes && !outside; ++p) {
            if ((planes >> p & 1) == 0) continue;
            const Plane& plane = m_frustum.planes[p];
            const double inner = pVertexDistance(plane, box);
            const double outer = plane.distance(box.centre) - glm::dot(glm::abs(plane.normal), box.halfExtent);
            outside = inner < -margin;
            if (outer > margin) entry.planes &= ~(1u << p);
            if (m_recording)
                say(entry.node,
                    atLine(QueryLine::Frustum, planeTest(subject, FrustumPlane(p), inner, outside ? inner : outer, margin)));
        }
        if (!outside && mayBeSeparated(entry.planes)) {
            outside = separated(m_frustum, box, margin);
            if (m_recording) say(entry.node, atLine(QueryLine::Frustum, axisTest(subject, outside, margin)));
        }
        if (outside) leaveOut(entry.node, QueryLine::Outside, Cause::OutsideFrustum);
        return !outside;
    }

    [[nodiscard]] bool isAsked(const Entry& entry, const EyeBox& grown, double growth) {
        // Infinities, NaN and numbers beyond the range of float cannot be passed to OpenGL.
        const double farthest = glm::length(grown.centre) + glm::length(grown.halfExtent);
        const char* reason = nullptr;
        if (!m_anything)
            reason = CULLSCOPE_TR("Nothing is drawn yet that could hide its box: it counts as visible without asking.");
        else if (!(farthest < 1e30) || !(nearestAhead(grown, m_frustum) > m_frustum.nearDistance))
            reason = CULLSCOPE_TR("Its box, grown by %2, reaches before the near plane: it counts as visible without asking.");
        else
            return m_options.inner || node(entry.node).leaf();
        if (m_recording) say(entry.node, atLine(QueryLine::Unasked, result(entry.node, growth, true, reason)));
        return false;
    }

    void ask(std::vector<Question> questions) {
        worked(kStepsOfAQuestion * questions.size());
        std::vector<EyeBox> boxes;
        for (const Question& question : questions) boxes.push_back(question.box);
        m_counters.asked += boxes.size();
        ++m_counters.batches;
        m_batch = std::min(2 * m_batch, m_options.batch);
        std::vector<Answer> answers(boxes.size(), Answer::Hidden);
        if (m_options.latency == 0) {
            for (const uint32_t hit : m_frame.visibleBoxes(std::move(boxes), BoxQuestion::DepthSoFar))
                answers[hit] = Answer::Visible;
        } else {
            AskedNodes asked{m_frame.ask(std::move(boxes), BoxQuestion::DepthSoFar), {}};
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
            if (m_recording) say(number, atLine(QueryLine::Ask, answered(number, questions[i].growth, answers[i])));
            if (answers[i] == Answer::Hidden) {
                ++m_counters.hidden;
                leaveOut(number, QueryLine::Hidden, Cause::Hidden);
                continue;
            }
            const size_t top = m_stack.size();
            goOn(questions[i].entry);
            std::rotate(m_stack.begin() + std::ptrdiff_t(bottom), m_stack.begin() + std::ptrdiff_t(top), m_stack.end());
        }
    }

    /// With a visible node: with its parts, or its objects.
    void goOn(const Entry& entry) {
        if (node(entry.node).leaf())
            gather(entry.node);
        else
            pushParts(entry);
    }

    void gather(uint32_t leaf) {
        for (const uint32_t instance : m_octree.instancesOf(node(leaf))) {
            m_work.step();
            m_gathered.push_back({instance, 0, uint32_t(m_frame.scene().meshOf(instance).indices().size())});
            if (!m_recording) continue;
            Decision drawn = atLine(QueryLine::Draw, ending(Subject::ofObject(instance), Decision::Outcome::Drawn));
            drawn.nesting = uint8_t(node(leaf).depth + 1);
            m_frame.say(drawn);
        }
        m_anything = true;
    }

    void drawGathered() {
        if (m_gathered.empty()) return;
        m_frame.draw({m_frame.facing(), std::move(m_gathered)});
        m_gathered.clear();
    }

    /// The parts of a node, the nearest one on top.
    void pushParts(const Entry& entry) {
        struct Part {
            double distance = 0.0, toCentre = 0.0;
            uint32_t node = 0;
        };
        const Node& whole = node(entry.node);
        std::vector<Part> parts;
        for (uint32_t child = whole.firstChild; child < whole.firstChild + whole.childCount; ++child) {
            const EyeBox box = relativeToEye(node(child).box, m_eye);
            const Vec3 beyond = glm::max(glm::abs(box.centre) - box.halfExtent, Vec3(0.0));
            parts.push_back({glm::dot(beyond, beyond), glm::dot(box.centre, box.centre), child});
        }
        std::ranges::stable_sort(parts, [](const Part& a, const Part& b) {
            return a.distance != b.distance ? a.distance > b.distance : a.toCentre > b.toCentre;
        });
        for (const Part& part : parts) m_stack.push_back({part.node, entry.planes});
    }

    void leaveOut(uint32_t number, QueryLine line, Cause cause) {
        m_frame.counters().culledTriangles[size_t(cause)] += node(number).triangles;
        if (!m_recording) return;
        Decision decision = atLine(line, ending(Subject::ofNode(number), Decision::Outcome::Culled, cause));
        open(number);
        decision.nesting = node(number).depth;
        m_frame.say(decision, m_octree.instancesOf(node(number)));
    }

    // ---- Decisions

    /// A test by a box: its operands are the latency in frames, and the growth.
    [[nodiscard]] Decision result(uint32_t number, double growth, bool visible, const char* sentence) const {
        Decision decision;
        decision.subject = Subject::ofNode(number);
        decision.containment = visible ? Containment::Straddles : Containment::Outside;
        decision.cause = Cause::Hidden;
        decision.sentence = sentence;
        decision.operands = {double(m_options.latency), growth};
        decision.operandCount = 2;
        return decision;
    }

    [[nodiscard]] Decision answered(uint32_t number, double growth, Answer answer) const {
        const bool visible = answer != Answer::Hidden;
        if (m_options.latency == 0)
            return result(number, growth, visible,
                          visible ? CULLSCOPE_TR("OpenGL was asked about its box, grown by %2: it shows before what is drawn.")
                                  : CULLSCOPE_TR("OpenGL was asked about its box, grown by %2: what is drawn hides all of it."));
        return result(
            number, growth, visible,
            answer == Answer::Unknown
                ? CULLSCOPE_TR("Its box was not asked about %1 frames ago: it counts as visible, and is asked about now.")
            : visible ? CULLSCOPE_TR("Its box, grown by %2, is asked about; %1 frames ago the answer was that it shows.")
                      : CULLSCOPE_TR("Its box, grown by %2, is asked about; %1 frames ago the answer was that it is hidden."));
    }

    void say(uint32_t number, Decision decision) {
        open(number);
        decision.nesting = node(number).depth;
        m_frame.say(decision);
    }

    /// Says that the parts of the nodes around this one are visited, where that was not said last.
    void open(uint32_t number) {
        std::array<uint32_t, InstanceOctree::kMaxDepth + 1> around{};
        const size_t depth = node(number).depth;
        uint32_t outer = number;
        for (size_t level = depth; level > 0; --level) around[level - 1] = outer = uint32_t(node(outer).parent);
        for (size_t level = 0; level < depth; ++level) {
            if (level < m_open.size() && m_open[level].node == around[level] && m_open[level].parts) continue;
            Decision parts = atLine(QueryLine::Children, result(around[level], 0.0, true,
                                                                CULLSCOPE_TR("The box counts as visible: its parts are visited, "
                                                                             "nearest first.")));
            parts.operandCount = 0;
            parts.nesting = uint8_t(level);
            m_frame.say(parts);
            m_open.resize(level);
            m_open.push_back({around[level], true});
        }
        m_open.resize(depth);
        m_open.push_back({number, false});
    }

    const InstanceOctree& m_octree;
    FrameContext& m_frame;
    const Frustum& m_frustum;
    Vec3 m_eye;
    bool m_recording;
    QueryOptions m_options;
    std::deque<AskedFrame>& m_past;
    Progress m_progress;
    WorkCheck m_work;
    size_t m_batch = 1;                 ///< boxes that the next batch has at most
    std::vector<Answer> m_known;        ///< by node, of the frame whose answers are used; at latency 0 empty
    AskedFrame m_asked;                 ///< in this frame
    std::vector<Entry> m_stack;         ///< the next one is the last
    std::vector<DrawRange> m_gathered;  ///< the objects to be drawn before the next question
    bool m_anything = false;            ///< is drawn, or gathered
    std::vector<OpenNode> m_open;       ///< by depth
    QueryCounters m_counters;
};

}  // namespace

QueryCounters walkByQueries(const InstanceOctree& octree, FrameContext& frame, const QueryOptions& options,
                            std::deque<AskedFrame>& past) {
    return QueryWalk(octree, frame, options, past).run();
}

}  // namespace cullscope::occlusion
