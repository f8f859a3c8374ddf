#pragma once

#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"
#include "tests/support/culler.h"

namespace cullscope::test {

struct GroupedObjects : Structure {
    using Structure::Structure;
    InstanceOctree octree;
};

/// The smallest strategy over a hierarchy of instances: draws the objects that the walk keeps.
class GroupedFrustum final : public StrategyWith<GroupedObjects> {
protected:
    void fill(GroupedObjects& structure, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        structure.octree = InstanceOctree(structure.scene());
        structure.report.bytes = structure.octree.bytes();
    }
    void decide(FrameContext& frame, const GroupedObjects& structure, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        OctreeWalkCounters counters;
        DrawList list{frame.facing(), {}};
        for (const KeptObject& kept : keptObjects(structure.octree, frame, &counters)) {
            list.ranges.push_back(
                {kept.instance, 0, static_cast<uint32_t>(3 * frame.scene().meshOf(kept.instance).triangleCount())});
            if (frame.recording()) frame.say(ending(Subject::ofObject(kept.instance), Decision::Outcome::Drawn));
        }
        frame.counters().nodesVisited = counters.nodesVisited;
        frame.counters().culledTriangles[size_t(Cause::OutsideFrustum)] = counters.trianglesCulled;
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const GroupedObjects& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const GroupedObjects& structure, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, structure.scene());
        addGroups(result, structure.octree, structure.scene(), log);
        return result;
    }
};

/// That strategy over one scene after another.
class GroupedCuller : public Culler {
public:
    GroupedCuller() : Culler({info(), std::make_shared<GroupedFrustum>()}) {}

    [[nodiscard]] const InstanceOctree& octree() const {
        return static_cast<const GroupedObjects&>(*built()->structure()).octree;
    }

private:
    static StrategyInfo info() {
        StrategyInfo info{"grouped-frustum", "", "", "", {}};
        info.shows = {treeShow()};
        return info;
    }
};

}  // namespace cullscope::test
