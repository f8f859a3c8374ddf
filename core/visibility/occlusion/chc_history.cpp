#include "core/visibility/occlusion/chc_history.h"

#include <algorithm>
#include <utility>

#include "core/geometry/random.h"

namespace cullscope::occlusion {

ChcFrameHistory::ChcFrameHistory(const InstanceOctree& octree, const ChcHistory& before, const RetestOptions& options)
    : m_octree(octree), m_options(options), m_history(before) {
    m_history.nodes.resize(octree.nodes().size());
    ++m_history.frames;
}

std::vector<ChcQuestion> ChcFrameHistory::takeAsked() { return std::exchange(m_history.asked, {}); }

void ChcFrameHistory::answer(const ChcQuestion& question, const std::optional<std::vector<uint32_t>>& hits) {
    uint32_t first = 0;
    for (uint32_t group = 0; group < question.ends.size(); ++group) {
        const uint32_t end = question.ends[group];
        const bool shows = !hits || std::ranges::binary_search(*hits, group);
        for (const uint32_t number : std::span(question.nodes).subspan(first, end - first)) {
            NodeHistory& history = m_history.nodes[number];
            if (!shows) {
                becomesHidden(number, now() - 1);
                m_changed.push_back(number);
            } else if (hits && end - first == 1) {
                history.next = now() - 1 + (history.visible ? m_options.every : firstRetest(number));
                this->shows(number);
            } else {
                history.seen = 0;
                showAround(number);
            }
        }
        first = end;
    }
}

void ChcFrameHistory::pullDown() {
    for (const uint32_t changed : m_changed)
        for (int32_t above = m_octree.nodes()[changed].parent; above >= 0; above = m_octree.nodes()[size_t(above)].parent) {
            if (!allPartsHidden(m_octree.nodes()[size_t(above)])) break;
            if (m_history.nodes[size_t(above)].visible) becomesHidden(uint32_t(above), now() - 1);
        }
    m_changed.clear();
}

bool ChcFrameHistory::allPartsHidden(const InstanceOctree::Node& node) const {
    return std::ranges::all_of(std::span(m_history.nodes).subspan(node.firstChild, node.childCount),
                               [&](const NodeHistory& part) { return part.seen + 1 == now() ? !part.visible : m_options.waits; });
}

NodeHistory ChcFrameHistory::visit(uint32_t number) {
    NodeHistory& history = m_history.nodes[number];
    if (history.seen + 1 != now()) history = {};
    const NodeHistory before = history;
    history.seen = now();
    return before;
}

void ChcFrameHistory::leafShows(uint32_t leaf, bool before) {
    if (!before) m_history.nodes[leaf].next = now() + firstRetest(leaf);
    shows(leaf);
}

void ChcFrameHistory::partsAreVisited(uint32_t number) {
    m_history.nodes[number].visible = false;
    m_history.nodes[number].since = now();
}

void ChcFrameHistory::shows(uint32_t number) {
    m_history.nodes[number].visible = true;
    showAround(number);
}

void ChcFrameHistory::showAround(uint32_t number) {
    for (int32_t above = m_octree.nodes()[number].parent; above >= 0 && !m_history.nodes[size_t(above)].visible;
         above = m_octree.nodes()[size_t(above)].parent)
        m_history.nodes[size_t(above)].visible = true;
}

void ChcFrameHistory::hides(uint32_t number) { becomesHidden(number, now()); }

void ChcFrameHistory::becomesHidden(uint32_t number, uint64_t frame) {
    NodeHistory& history = m_history.nodes[number];
    if (history.visible || history.since == 0) history.since = frame;
    history.visible = false;
}

void ChcFrameHistory::isOutside(uint32_t number) {
    // What is hidden is not asked about in the frame that visits it: what comes into sight is found only by visiting it.
    if (!m_options.waits) showAround(number);
}

uint64_t ChcFrameHistory::framesHidden(uint32_t number) const {
    const NodeHistory& history = m_history.nodes[number];
    return history.visible || history.since == 0 ? 0 : now() - history.since;
}

uint64_t ChcFrameHistory::firstRetest(uint32_t leaf) const {
    if (!m_options.random) return m_options.every;
    // By the node and the frame alone: a frame that is repeated decides the same.
    return 1 + Random(uint64_t(leaf) << 32 ^ now()).bits() % m_options.every;
}

}  // namespace cullscope::occlusion
