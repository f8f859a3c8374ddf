#pragma once

#include "core/visibility/octree_walk.h"
#include "core/visibility/strategy.h"

namespace cullscope::test {

/// The smallest strategy over a hierarchy of instances: draws the objects that the walk keeps.
class GroupedFrustum final : public Strategy {
public:
    GroupedFrustum() : Strategy(ParameterSet(std::vector<ParameterDeclaration>{})) {}

    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] const InstanceOctree& octree() const { return m_octree; }
    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override {
        StructureSnapshot result;
        for (uint32_t i = 0; i < scene().instances().size(); ++i) {
            if (scene().meshOf(i).triangleCount() == 0) continue;
            SnapshotNode node;
            node.instance = i;
            node.box = scene().instanceBox(i);
            node.triangles = scene().meshOf(i).triangleCount();
            for (const TraceEvent& event : trace.events) {
                if (event.instance != i || event.containment != Containment::Outside) continue;
                node.culled = true;
                node.containment = Containment::Outside;
                node.rejectedBy = event.plane;
            }
            result.nodes.push_back(node);
        }
        addGroups(result, m_octree, scene(), trace);
        return result;
    }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        m_octree = InstanceOctree(scene);
        report.bytes = m_octree.bytes();
    }
    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        OctreeWalkCounters figures;
        for (const KeptObject& kept : keptObjects(m_octree, scene(), view, &figures, trace)) {
            verdict.drawList.ranges.push_back(
                {kept.instance, 0, static_cast<uint32_t>(3 * scene().meshOf(kept.instance).triangleCount())});
            if (trace != nullptr) trace->events.push_back({TraceEvent::Kind::Accepted, kept.instance});
        }
        verdict.nodesVisited = figures.nodesVisited;
        verdict.culledTriangles[size_t(Cause::OutsideFrustum)] = figures.trianglesCulled;
    }

private:
    InstanceOctree m_octree;
};

}  // namespace cullscope::test
