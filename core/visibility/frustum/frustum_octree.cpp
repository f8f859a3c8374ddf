#include "core/visibility/frustum/frustum_octree.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::frustum {
namespace {

class FrustumOctree final : public Strategy {
public:
    explicit FrustumOctree(ParameterSet set) : Strategy(std::move(set)), m_refine(parameters().boolean("refine")) {}

    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }
    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override {
        StructureSnapshot result = objectNodes(trace, scene());
        addGroups(result, m_octree, scene(), trace);
        return result;
    }

protected:
    void buildStructures(const Scene& scene, const Progress& /*progress*/, StructureReport& report) override {
        m_octree = InstanceOctree(scene);
        m_memory = LastFailedPlanes(m_octree.nodes().size(), scene.instances().size());
        report.bytes = m_octree.bytes() + m_memory.bytes();
        uint8_t depth = 0;
        size_t leaves = 0;
        for (const InstanceOctree::Node& node : m_octree.nodes()) {
            depth = std::max(depth, node.depth);
            leaves += node.leaf() ? 1 : 0;
        }
        report.figures = {{"objects", double(scene.instances().size())},
                          {"nodes", double(m_octree.nodes().size())},
                          {"leaves", double(leaves)},
                          {"depth", double(depth)}};
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        OctreeWalkCounters figures;
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("groups of objects"));
            kept = keptObjects(m_octree, scene(), view, &figures, trace, {m_refine, &m_memory});
        }
        const StageTimer stage(verdict, CULLSCOPE_TR("draw list"));
        sortNearestFirst(kept, scene(), view.eye());
        for (const KeptObject& object : kept) {
            const auto indices = static_cast<uint32_t>(scene().meshOf(object.instance).indices().size());
            verdict.drawList.ranges.push_back({object.instance, 0, indices});
            if (trace != nullptr) record(object.instance, view, *trace);
        }
        verdict.culledTriangles[size_t(Cause::OutsideFrustum)] = figures.trianglesCulled;
        verdict.nodesVisited = figures.nodesVisited + figures.objectsTested;
        verdict.bytesTouched = figures.nodesVisited * sizeof(InstanceOctree::Node) + figures.objectsTested * sizeof(Box3);
    }

private:
    /// Records the plane tests of a kept object by its own bounds, also of planes that the tests of its groups made unnecessary.
    void record(uint32_t instance, const View& view, Trace& trace) const {
        const EyeBounds bounds = boundsFromEye(scene(), instance, view.eye());
        for (size_t p = 0; p < view.frustum().planes.size(); ++p) {
            const Plane& plane = view.frustum().planes[p];
            // Its group's tests show that it is outside no plane.
            addPlaneTest(trace, instance, static_cast<FrustumPlane>(p), std::max(farthestInside(plane, bounds), -bounds.margin),
                         farthestOutside(plane, bounds), bounds.margin);
        }
        trace.events.push_back({TraceEvent::Kind::Accepted, instance});
    }

    bool m_refine;
    InstanceOctree m_octree;
    LastFailedPlanes m_memory;
};

}  // namespace

StrategyInfo frustumOctreeInfo() {
    return {"frustum-octree",
            CULLSCOPE_TR("View-frustum culling by groups"),
            CULLSCOPE_TR("Leaves out whole groups of objects by an octree over their boxes, and draws the rest nearest first."),
            "Assarsson & Möller 2000; Gottschalk, Lin & Manocha 1996",
            {facingParameter(),
             booleanParameter("refine", true,
                              CULLSCOPE_TR("Whether what several planes cut is tested by separating axes too, which leaves out "
                                           "what lies beside the frustum's edges."))}};
}

StrategyPointer makeFrustumOctree(ParameterSet parameters) { return std::make_unique<FrustumOctree>(std::move(parameters)); }

}  // namespace cullscope::frustum
