#include "core/visibility/structure_snapshot.h"

namespace cullscope {

void markTested(StructureSnapshot& snapshot, const FrameLog& log) {
    std::vector<bool> groups, objects;  // by number
    const auto add = [](std::vector<bool>& tested, uint32_t number) {
        if (number >= tested.size()) tested.resize(number + 1, false);
        tested[number] = true;
    };
    for (const Decision& decision : log.decisions) {
        // An end with a sentence of its own is a test with its result.
        if (decision.outcome != Decision::Outcome::Open && decision.sentence == nullptr) continue;
        if (decision.subject.kind == Subject::Kind::Node) add(groups, decision.subject.number);
        if (decision.subject.kind == Subject::Kind::Object) add(objects, decision.subject.number);
    }
    const auto has = [](const std::vector<bool>& tested, uint32_t number) { return number < tested.size() && tested[number]; };
    for (SnapshotNode& node : snapshot.nodes)
        node.tested = node.isGroup() ? has(groups, node.number) : has(objects, node.instance);
}

}  // namespace cullscope
