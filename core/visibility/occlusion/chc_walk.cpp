#include "core/visibility/occlusion/chc_walk.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

#include "core/visibility/occlusion/chc_groups.h"
#include "core/visibility/occlusion/node_walk.h"

namespace cullscope::occlusion {
namespace {

constexpr NodeWalkLines kChcLines{uint8_t(ChcLine::Frustum), uint8_t(ChcLine::Outside), uint8_t(ChcLine::Unasked),
                                  uint8_t(ChcLine::Hidden),  uint8_t(ChcLine::Parts),   uint8_t(ChcLine::Draw)};

/// A node that is to be visited.
struct Near {
    Nearness nearness;
    NodeEntry entry;

    /// Of a queue whose first is the nearest; equally near nodes come by their numbers.
    bool operator<(const Near& other) const {
        return nearness != other.nearness ? nearness > other.nearness : entry.node > other.entry.node;
    }
};

/// A node about which OpenGL is asked.
struct Asked {
    NodeEntry entry;
    std::vector<EyeBox> boxes;
    double staysHidden = 0.0;  ///< probability
};

/// Queries of this frame whose answers are still due.
struct Flight {
    BoxTicketPointer ticket;
    std::vector<std::vector<Asked>> groups;
};

class ChcWalk : private NodeWalk {
public:
    ChcWalk(const InstanceOctree& octree, FrameContext& frame, const ChcOptions& options, const ChcHistory& history)
        : NodeWalk(octree, frame, kChcLines), m_octree(octree), m_options(options), m_history(octree, history, options.retest) {}

    ChcCounters run() {
        takeAnswers();
        if (!m_octree.nodes().empty()) m_queue.push({{}, {}});
        while (!m_queue.empty() || !m_batch.empty() || m_flight) {
            if (!m_queue.empty())
                visitNearest();
            else if (m_flight)
                land();
            else
                askBatch();
            if (m_batch.size() >= m_options.batch) askBatch();
        }
        drawGathered();
        askLater();
        countVisited();
        return m_counters;
    }

    /// What the view remembers after the frame.
    [[nodiscard]] ChcHistory take() { return m_history.take(); }

private:
    void takeAnswers() {
        for (const ChcQuestion& question : m_history.takeAsked()) {
            worked(kStepsOfAnAnswer * question.nodes.size());
            m_history.answer(question, frame().answer(*question.ticket));
        }
        m_history.pullDown();
    }

    // ---- The walk

    void visitNearest() {
        NodeEntry entry = m_queue.top().entry;
        m_queue.pop();
        visited();
        const std::optional<GrownBox> box = boxInFrustum(entry);
        if (!box) return m_history.isOutside(entry.node);
        const NodeHistory before = m_history.visit(entry.node);
        const bool leaf = node(entry.node).leaf();
        if (visibleUnasked(entry.node, *box)) return show(entry, before.visible);
        if (before.visible) {
            sayVisible(entry.node, CULLSCOPE_TR("It was visible in the frame before: it counts as visible without asking."));
            if (leaf && before.next <= m_history.now()) askAtTheEnd(entry, *box);
            return show(entry, true);
        }
        if (before.seen > 0 || m_options.latency == 0) {
            const auto frames = double(m_history.framesHidden(entry.node));
            m_batch.push_back({entry, boxesOf(entry.node, *box), 0.99 - 0.7 * std::exp(-frames)});
            if (m_options.latency > 0) leaveOutForNow(entry.node);
            return;
        }
        sayVisible(entry.node, CULLSCOPE_TR("There is no answer about it of the frame before: it counts as visible."));
        if (leaf) askAtTheEnd(entry, *box);
        show(entry, false);
    }

    /// Goes on with a visible node: with its parts, or with its objects. `before`: it was visible in the frame before.
    void show(const NodeEntry& entry, bool before) {
        const Node& whole = node(entry.node);
        if (whole.leaf()) {
            gather(entry.node);
            return m_history.leafShows(entry.node, before);
        }
        m_history.partsAreVisited(entry.node);
        for (uint32_t part = whole.firstChild; part < whole.firstChild + whole.childCount; ++part)
            m_queue.push({nearness(part), {part, entry.planes}});
    }

    // ---- Questions

    [[nodiscard]] std::vector<EyeBox> boxesOf(uint32_t number, const GrownBox& own) {
        std::vector<EyeBox> boxes;
        for (const Box3& box : tightBoxes(m_octree, frame().scene(), number, m_options.depth, m_options.area)) {
            const GrownBox tight = grown(box);
            if (!canBeAskedAbout(tight)) return {own.box};
            boxes.push_back(tight.box);
        }
        return boxes;
    }

    void askAtTheEnd(const NodeEntry& entry, const GrownBox& box) {
        m_later.push_back({entry, boxesOf(entry.node, box)});
        if (recording())
            say(entry.node,
                atLine(ChcLine::Retest, result(entry.node, true,
                                               CULLSCOPE_TR("At the end of the frame OpenGL is asked about it, for the "
                                                            "next frame: boxes: %1."),
                                               {double(m_later.back().boxes.size())})));
    }

    /// Of the batch, hidden nodes together.
    void askBatch() {
        while (m_flight) land();
        std::vector<Asked> batch = std::exchange(m_batch, {});
        std::ranges::stable_sort(batch, std::greater{}, &Asked::staysHidden);
        std::vector<double> probabilities;
        for (const Asked& asked : batch) probabilities.push_back(asked.staysHidden);
        std::vector<std::vector<Asked>> groups;
        size_t first = 0;
        for (const size_t end : questionEnds(probabilities, m_options.together)) {
            groups.emplace_back(std::move_iterator(batch.begin() + std::ptrdiff_t(first)),
                                std::move_iterator(batch.begin() + std::ptrdiff_t(end)));
            first = end;
            m_counters.multi += groups.back().size() > 1 ? 1 : 0;
        }
        ask(std::move(groups));
    }

    void askLater() {
        std::vector<std::vector<Asked>> groups;
        for (Asked& asked : m_later) groups.push_back({std::move(asked)});
        m_counters.retests = groups.size();
        if (!groups.empty()) remember(put(groups), groups);
    }

    void ask(std::vector<std::vector<Asked>> groups) {
        drawGathered();
        BoxTicketPointer ticket = put(groups);
        if (m_options.latency > 0)
            remember(std::move(ticket), groups);
        else
            m_flight = Flight{std::move(ticket), std::move(groups)};
    }

    [[nodiscard]] BoxTicketPointer put(const std::vector<std::vector<Asked>>& groups) {
        std::vector<EyeBox> boxes;
        std::vector<uint32_t> ends;
        for (const std::vector<Asked>& group : groups) {
            for (const Asked& asked : group) boxes.insert(boxes.end(), asked.boxes.begin(), asked.boxes.end());
            ends.push_back(uint32_t(boxes.size()));
        }
        worked(kStepsOfAQuestion * boxes.size());
        m_counters.queries += groups.size();
        m_counters.boxes += boxes.size();
        ++m_counters.batches;
        return frame().ask(std::move(boxes), BoxQuestion::DepthSoFar, std::move(ends));
    }

    /// Keeps a question for the next frame.
    void remember(BoxTicketPointer ticket, const std::vector<std::vector<Asked>>& groups) {
        ChcQuestion question{std::move(ticket), {}, {}};
        for (const std::vector<Asked>& group : groups) {
            for (const Asked& asked : group) question.nodes.push_back(asked.entry.node);
            question.ends.push_back(uint32_t(question.nodes.size()));
        }
        m_history.ask(std::move(question));
    }

    /// Waits for the answers of this frame's queries and goes on with what is visible. Of several nodes that showed together each
    /// is asked about by itself.
    void land() {
        const Flight flight = *std::exchange(m_flight, std::nullopt);
        worked(kStepsOfAnAnswer * flight.groups.size());
        const std::optional<std::vector<uint32_t>> hits = frame().answer(*flight.ticket);
        std::vector<std::vector<Asked>> alone;
        for (uint32_t number = 0; number < flight.groups.size(); ++number) {
            const std::vector<Asked>& group = flight.groups[number];
            const bool shows = !hits || std::ranges::binary_search(*hits, number);
            m_counters.split += shows && group.size() > 1 ? 1 : 0;
            for (const Asked& asked : group) {
                sayAnswer(asked, group.size(), shows);
                if (!shows)
                    hide(asked.entry.node);
                else if (group.size() > 1)
                    alone.push_back({asked});
                else
                    showAsked(asked.entry);
            }
        }
        if (!alone.empty()) ask(std::move(alone));
    }

    /// A node of which the answer is that it shows is visible, whatever becomes of its parts.
    void showAsked(const NodeEntry& entry) {
        show(entry, false);
        m_history.shows(entry.node);
    }

    void hide(uint32_t number) {
        m_history.hides(number);
        ++m_counters.hidden;
        leaveOut(number, uint8_t(ChcLine::Hidden), Cause::Hidden);
    }

    void leaveOutForNow(uint32_t number) {
        if (recording())
            say(number, atLine(ChcLine::Ask, result(number, false,
                                                    CULLSCOPE_TR("By the answers of the frame before it is hidden; it is asked "
                                                                 "about for the next frame, boxes: %1."),
                                                    {double(m_batch.back().boxes.size())})));
        ++m_counters.hidden;
        leaveOut(number, uint8_t(ChcLine::Hidden), Cause::Hidden);
    }

    // ---- Decisions

    void sayVisible(uint32_t number, const char* sentence) {
        if (recording()) say(number, atLine(ChcLine::Unasked, result(number, true, sentence)));
    }

    void sayAnswer(const Asked& asked, size_t together, bool shows) {
        if (!recording()) return;
        const uint32_t number = asked.entry.node;
        const std::initializer_list<double> operands{double(asked.boxes.size()), double(together)};
        if (together == 1)
            return say(number, atLine(ChcLine::Ask, result(number, shows,
                                                           shows ? CULLSCOPE_TR("OpenGL was asked about it, boxes: %1; it shows "
                                                                                "before what is drawn.")
                                                                 : CULLSCOPE_TR("OpenGL was asked about it, boxes: %1; what is "
                                                                                "drawn hides all of it."),
                                                           operands)));
        if (shows)
            return say(number, atLine(ChcLine::Split, result(number, true,
                                                             CULLSCOPE_TR("OpenGL was asked about it, boxes: %1, and others at "
                                                                          "once, together %2; of these something shows, so "
                                                                          "each is asked about by itself."),
                                                             operands)));
        say(number, atLine(ChcLine::Ask, result(number, false,
                                                CULLSCOPE_TR("OpenGL was asked about it, boxes: %1, and others at once, together "
                                                             "%2; what is drawn hides all of them."),
                                                operands)));
    }

    const InstanceOctree& m_octree;
    ChcOptions m_options;
    ChcFrameHistory m_history;
    ChcCounters m_counters;
    std::priority_queue<Near> m_queue;  ///< nodes to be visited
    std::vector<Asked> m_batch;         ///< hidden nodes that OpenGL will be asked about (i-queue)
    std::vector<Asked> m_later;         ///< visible leaves that it will be asked about at the end (v-queue)
    std::optional<Flight> m_flight;
};

}  // namespace

ChcCounters walkCoherently(const InstanceOctree& octree, FrameContext& frame, const ChcOptions& options, ChcHistory& history) {
    ChcWalk walk(octree, frame, options, history);
    const ChcCounters counters = walk.run();
    history = walk.take();
    return counters;
}

}  // namespace cullscope::occlusion
