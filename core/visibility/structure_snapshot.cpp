#include "core/visibility/structure_snapshot.h"

namespace cullscope {
namespace {

/// Numbers that are added in any order.
class Numbers {
public:
    void add(uint32_t number) {
        if (number >= m_has.size()) m_has.resize(size_t(number) + 1, false);
        m_has[number] = true;
    }
    [[nodiscard]] bool has(uint32_t number) const { return number < m_has.size() && m_has[number]; }

private:
    std::vector<bool> m_has;
};

}  // namespace

void markTested(StructureSnapshot& snapshot, const FrameLog& log) {
    Numbers groups, objects;
    for (const Decision& decision : log.decisions) {
        // An end with a sentence of its own is a test with its result.
        if (decision.outcome != Decision::Outcome::Open && decision.sentence == nullptr) continue;
        if (decision.subject.kind == Subject::Kind::Node) groups.add(decision.subject.number);
        if (decision.subject.kind == Subject::Kind::Object) objects.add(decision.subject.number);
    }
    for (SnapshotNode& node : snapshot.nodes) node.tested = node.isGroup() ? groups.has(node.number) : objects.has(node.instance);
}

void markReached(StructureSnapshot& snapshot, const FrameLog& log) {
    if (log.whole) return;
    Numbers groups, objects;
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind == Subject::Kind::Node) groups.add(decision.subject.number);
        if (decision.subject.kind == Subject::Kind::Object) objects.add(decision.subject.number);
        if (decision.subject.object != Subject::kNoObject) objects.add(decision.subject.object);
        for (const uint32_t instance : log.objectsOf(decision)) objects.add(instance);
    }
    for (SnapshotNode& node : snapshot.nodes)
        node.reached = node.culled || (node.isGroup() ? groups.has(node.number) : objects.has(node.instance));
    // Nodes follow what they lie in.
    for (size_t i = snapshot.nodes.size(); i-- > 0;)
        if (const SnapshotNode& node = snapshot.nodes[i]; node.reached && node.parent >= 0)
            snapshot.nodes[size_t(node.parent)].reached = true;
}

}  // namespace cullscope
