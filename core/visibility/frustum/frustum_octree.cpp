#include "core/visibility/frustum/frustum_octree.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/frustum/rejected_objects.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::frustum {
namespace {

/// The lines of the listing (octreeListing).
enum class OctreeLine : uint8_t { Visit = 1, Planes, Axes, Outside, Inside, Children, Objects, ObjectOutside, Draw };

constexpr OctreeWalkLines kOctreeLines{.groupPlanes = uint8_t(OctreeLine::Planes),
                                       .groupAxes = uint8_t(OctreeLine::Axes),
                                       .groupOutside = uint8_t(OctreeLine::Outside),
                                       .groupInside = uint8_t(OctreeLine::Inside),
                                       .objectTests = uint8_t(OctreeLine::Objects),
                                       .objectOutside = uint8_t(OctreeLine::ObjectOutside)};

struct ObjectOctree : Structure {
    using Structure::Structure;
    InstanceOctree octree;
};

struct OctreeMemory : ViewState {
    LastFailedPlanes planes;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<OctreeMemory>(*this); }
};

class FrustumOctree final : public StrategyWith<ObjectOctree, OctreeMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<OctreeMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return rejectedObjects(log, structure.scene(), true);
    }

protected:
    void fill(ObjectOctree& structure, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
        const std::vector<InstanceOctree::Node>& nodes = structure.octree.nodes();
        // With the memory of one view.
        structure.report.bytes = structure.octree.bytes() + LastFailedPlanes(nodes.size(), scene.instances().size()).bytes();
        uint8_t depth = 0;
        size_t leaves = 0;
        for (const InstanceOctree::Node& node : nodes) {
            depth = std::max(depth, node.depth);
            leaves += node.leaf() ? 1 : 0;
        }
        structure.report.figures = {{"objects", double(scene.instances().size())},
                                    {"nodes", double(nodes.size())},
                                    {"leaves", double(leaves)},
                                    {"depth", double(depth)}};
    }

    void decide(FrameContext& frame, const ObjectOctree& structure, OctreeMemory& memory,
                const ParameterSet& parameters) const override {
        frame.draw(listed(frame, structure, memory, parameters));
    }

    [[nodiscard]] Promise promiseOf(const ObjectOctree& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const ObjectOctree& structure, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, structure.scene());
        addGroups(result, structure.octree, structure.scene(), log);
        return result;
    }

private:
    [[nodiscard]] static DrawList listed(FrameContext& frame, const ObjectOctree& structure, OctreeMemory& memory,
                                         const ParameterSet& parameters) {
        OctreeWalkCounters counters;
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("groups of objects"));
            kept = keptObjects(structure.octree, frame, &counters, {parameters.boolean("refine"), &memory.planes, kOctreeLines});
        }
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("draw list"));
            sortNearestFirst(kept, frame.scene(), frame.view().eye());
            for (const KeptObject& object : kept) {
                const auto indices = static_cast<uint32_t>(frame.scene().meshOf(object.instance).indices().size());
                list.ranges.push_back({object.instance, 0, indices});
                if (frame.recording())
                    frame.say(atLine(OctreeLine::Draw, ending(Subject::ofObject(object.instance), Decision::Outcome::Drawn)));
            }
        }
        FrameCounters& counted = frame.counters();
        counted.culledTriangles[size_t(Cause::OutsideFrustum)] = counters.trianglesCulled;
        counted.nodesVisited = counters.nodesVisited + counters.objectsTested;
        counted.bytesTouched = counters.nodesVisited * sizeof(InstanceOctree::Node) + counters.objectsTested * sizeof(Box3);
        counted.figures.push_back({"plane_tests", double(counters.planesTested)});
        return list;
    }
};

Show octreeListing() {
    return listingShow({{CULLSCOPE_TR("visit(group, planes that may cut it)"), 0},
                        {CULLSCOPE_TR("test its box against these planes"), 1},
                        {CULLSCOPE_TR("several cut it: test axes too"), 1},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("inside: keep all its objects"), 1},
                        {CULLSCOPE_TR("else visit(parts, cutting planes)"), 1},
                        {CULLSCOPE_TR("no parts: test each object too"), 1},
                        {CULLSCOPE_TR("outside: leave the object out"), 2},
                        {CULLSCOPE_TR("draw the objects kept, nearest first"), 0}});
}

}  // namespace

RegisteredStrategy frustumOctree() {
    StrategyInfo info{
        "frustum-octree",
        CULLSCOPE_TR("View-frustum culling by groups"),
        CULLSCOPE_TR("Leaves out whole groups of objects by an octree over their boxes, and draws the rest nearest first."),
        "Assarsson & Möller 2000; Gottschalk, Lin & Manocha 1996",
        {facingParameter(),
         booleanParameter("refine", true,
                          CULLSCOPE_TR("Whether what several planes cut is tested by separating axes too, which leaves out "
                                       "what lies beside the frustum's edges."))}};
    info.shows = {treeShow(), planesShow(), octreeListing(), rejectedObjectsShow()};
    return {std::move(info), std::make_shared<FrustumOctree>()};
}

}  // namespace cullscope::frustum
