#include "ui/jobs/object_verdicts.h"

#include <algorithm>

namespace cullscope::ui {

void ObjectVerdicts::set(const ScenePointer& scene, const std::shared_ptr<const TriangleStates>& states,
                         const SnapshotReadingPointer& reading) {
    const std::shared_ptr<const StructureSnapshot> snapshot = reading ? reading->snapshot : nullptr;
    if (scene == m_scene && states == m_states && snapshot == m_snapshot) return;
    m_scene = scene;
    m_states = states;
    m_snapshot = snapshot;
    const size_t count = scene ? scene->instances().size() : 0;
    m_known.assign(states ? count : 0, -1);
    m_nodes.assign(states || !snapshot ? 0 : count, -1);
    if (m_nodes.empty()) return;
    std::vector<bool> holdsOthers(snapshot->nodes.size(), false);
    for (const SnapshotNode& node : snapshot->nodes)
        if (node.parent >= 0) holdsOthers[size_t(node.parent)] = true;
    for (size_t node = snapshot->nodes.size(); node-- > 0;)
        if (!holdsOthers[node] && !snapshot->nodes[node].isGroup()) m_nodes[snapshot->nodes[node].instance] = int64_t(node);
}

TriangleState ObjectVerdicts::fromStates(uint32_t instance) const {
    std::array<uint64_t, kTriangleStateCount> counts{};
    const uint64_t first = m_scene->firstTriangle(instance);
    for (uint64_t i = 0; i < m_scene->meshOf(instance).triangleCount(); ++i) ++counts[size_t(m_states->states[first + i])];
    for (const TriangleState state : {TriangleState::WronglyCulled, TriangleState::Visible, TriangleState::InVain})
        if (counts[size_t(state)] > 0) return state;
    return TriangleState(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

std::optional<ObjectVerdicts::Verdict> ObjectVerdicts::of(uint32_t instance) const {
    if (!m_scene || m_scene->meshOf(instance).triangleCount() == 0) return std::nullopt;
    if (m_states) {
        int8_t& known = m_known[instance];
        if (known < 0) known = int8_t(fromStates(instance));
        return Verdict{TriangleState(known), m_states->againstTruth};
    }
    if (m_nodes.empty() || m_nodes[instance] < 0) return std::nullopt;
    const SnapshotNode& node = m_snapshot->nodes[size_t(m_nodes[instance])];
    return Verdict{node.culled ? stateOfCause(node.cause) : TriangleState::Visible, false};
}

}  // namespace cullscope::ui
