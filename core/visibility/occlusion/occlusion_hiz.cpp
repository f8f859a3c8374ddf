#include "core/visibility/occlusion/occlusion_hiz.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/base/work_check.h"
#include "core/spatial/part_boxes.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/query_octree.h"
#include "core/visibility/occlusion/two_passes.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kRounds = "rounds";
/// A box that is grown and tested takes about as long as this many steps (work_check.h).
constexpr int kStepsOfABox = 4;

/// The lines of the listing.
enum class HizLine : uint8_t { Groups = 1, Outside, First, Rounds, Reduce, Test, Hidden, Draw, Again, Next };

constexpr OctreeWalkLines kHizWalkLines{.groupPlanes = uint8_t(HizLine::Groups),
                                        .groupAxes = uint8_t(HizLine::Groups),
                                        .groupOutside = uint8_t(HizLine::Outside),
                                        .groupInside = uint8_t(HizLine::Groups),
                                        .objectTests = uint8_t(HizLine::Groups),
                                        .objectOutside = uint8_t(HizLine::Outside)};
constexpr TwoPassLines kHizLines{.first = uint8_t(HizLine::First),
                                 .reduce = uint8_t(HizLine::Reduce),
                                 .test = uint8_t(HizLine::Test),
                                 .hidden = uint8_t(HizLine::Hidden),
                                 .draw = uint8_t(HizLine::Draw),
                                 .again = uint8_t(HizLine::Again),
                                 .next = uint8_t(HizLine::Next)};

struct HizOctree : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    PartBoxes parts;
};

struct HizMemory : ViewState {
    LastFailedPlanes planes;
    LastVisible last;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<HizMemory>(*this); }
};

class OcclusionHiz final : public StrategyWith<HizOctree, HizMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<HizMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto count = [&](HizLine line, Decision::Outcome outcome) {
            return uint64_t(std::ranges::count_if(log.decisions, [&](const Decision& decision) {
                return decision.line == uint8_t(line) && decision.outcome == outcome;
            }));
        };
        using enum Decision::Outcome;
        return {{},
                {{CULLSCOPE_TR("objects drawn first"), count(HizLine::First, Drawn), TriangleState::Visible},
                 {CULLSCOPE_TR("objects tested"), count(HizLine::Test, Open)},
                 {CULLSCOPE_TR("objects hidden"), count(HizLine::Hidden, Culled), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects drawn after a test"), count(HizLine::Draw, Drawn), TriangleState::Visible},
                 {CULLSCOPE_TR("objects for the next frame"), count(HizLine::Next, Open)}}};
    }

    [[nodiscard]] NamedParts partsByLeaf(const Structure& structure, const FrameLog& /*log*/) const override {
        return objectsByLeaf(own(structure).octree, structure.scene());
    }

protected:
    void fill(HizOctree& structure, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
        structure.parts = PartBoxes(scene, progress);
        structure.report.bytes = structure.octree.bytes() + structure.parts.bytes();
        uint64_t boxes = 0;
        for (uint32_t i = 0; i < scene.instances().size(); ++i) boxes += std::max<size_t>(structure.parts.of(i).size(), 1);
        structure.report.figures = {{"objects", double(scene.instances().size())},
                                    {"nodes", double(structure.octree.nodes().size())},
                                    {"boxes", double(boxes)}};
    }

    void decide(FrameContext& frame, const HizOctree& structure, HizMemory& memory,
                const ParameterSet& parameters) const override {
        const StageTimer stage(frame, CULLSCOPE_TR("walk and pyramid"));
        OctreeWalkCounters walked;
        OctreeWalkOptions walk{.refine = true, .memory = &memory.planes, .lines = kHizWalkLines, .visited = {}};
        // A group within the frustum is not drawn as a whole: what is hidden is found object by object.
        walk.visited = [](uint32_t /*node*/, uint32_t /*planes*/) { return true; };
        std::vector<KeptObject> kept = keptObjects(structure.octree, frame, &walked, walk);
        sortNearestFirst(kept, frame.scene(), frame.view().eye());
        const DrawnParts parts = partsOf(frame, structure, kept);
        TwoPassOptions options{.rounds = size_t(parameters.integer(kRounds)), .lines = kHizLines, .like = {frame.facing(), {}}};
        FrameCounters& counters = frame.counters();
        counters.culledTriangles[size_t(Cause::OutsideFrustum)] = walked.trianglesCulled;
        counters.nodesVisited = walked.nodesVisited + walked.objectsTested;
        counters.bytesTouched = walked.nodesVisited * sizeof(InstanceOctree::Node) + walked.objectsTested * sizeof(Box3) +
                                parts.boxCount() * sizeof(Box3);
        const TwoPassCounters counted = drawInTwoPasses(frame, parts, options, memory.last);
        counters.workBytes = counted.pyramids > 0 ? pyramidBytes(frame.view().viewport()) : 0;
        counters.figures = {{"first_objects", double(counted.first)},
                            {"tested_objects", double(counted.tested)},
                            {"tested_boxes", double(counted.boxes)},
                            {"pyramids", double(counted.pyramids)}};
    }

    [[nodiscard]] Promise promiseOf(const HizOctree& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const HizOctree& structure, const FrameLog& log) const override {
        StructureSnapshot tree = objectNodes(log, structure.scene());
        tree.objectSentence = CULLSCOPE_TR("The object \"%1\" lies in a box of the octree; it has %2 triangles.");
        tree.groupSentence = CULLSCOPE_TR("It lies in a group of %1 objects, of which some are in the frustum.");
        addGroups(tree, structure.octree, structure.scene(), log);
        return tree;
    }

private:
    /// The objects with triangles, by the boxes of their parts, or by their own.
    static DrawnParts partsOf(const FrameContext& frame, const HizOctree& structure, const std::vector<KeptObject>& kept) {
        const Progress progress{nullptr, frame.stop()};
        WorkCheck work(progress);
        const Scene& scene = frame.scene();
        DrawnParts parts(frame.view());
        for (const auto& [instance, planes] : kept) {
            const auto indices = uint32_t(scene.meshOf(instance).indices().size());
            if (indices == 0) continue;
            parts.add(instance, Subject::ofObject(instance), {instance, 0, indices});
            const std::span<const Box3> smaller = structure.parts.of(instance);
            for (const Box3& box : smaller.empty() ? std::span(&scene.instanceBox(instance), 1) : smaller) {
                for (int step = 0; step < kStepsOfABox; ++step) work.step();
                parts.addBox(grownBox(box, frame.view()));
            }
        }
        return parts;
    }
};

Show hizListing() {
    return listingShow({{CULLSCOPE_TR("test groups, objects by planes"), 0},
                        {CULLSCOPE_TR("outside: leave it all out"), 1},
                        {CULLSCOPE_TR("visible before, or near: draw it"), 0},
                        {CULLSCOPE_TR("the others by rounds, nearest first"), 0},
                        {CULLSCOPE_TR("reduce the depth drawn to a pyramid"), 1},
                        {CULLSCOPE_TR("test boxes against its texels"), 1},
                        {CULLSCOPE_TR("behind all: hidden, leave it out"), 2},
                        {CULLSCOPE_TR("else draw it, in the same frame"), 2},
                        {CULLSCOPE_TR("reduce again, test all: hidden now"), 0},
                        {CULLSCOPE_TR("else visible for the next frame"), 0}});
}

}  // namespace

RegisteredStrategy occlusionHiz() {
    StrategyInfo info{
        "occlusion-hiz",
        CULLSCOPE_TR("Hierarchical depth in two passes"),
        CULLSCOPE_TR(
            "Draws what was visible in the frame before, and has the GPU test all else against a pyramid of its depth and "
            "draw it in the same frame."),
        "Greene, Kass & Miller 1993; Haar & Aaltonen 2015",
        {facingParameter(),
         wholeParameter(kRounds, 2, 1, 8,
                        CULLSCOPE_TR("In how many rounds the other objects are tested and drawn, the nearest first: what one "
                                     "draws hides what the next one tests."))},
        GlRequirement::Context};
    info.remembers = true;
    info.sweeps = {{kRounds, {"1", "2", "3", "4", "6"}}};
    info.shows = {treeShow(), hizListing(), barsShow("pyramid-objects", CULLSCOPE_TR("Objects by the depth pyramid"))};
    return {std::move(info), std::make_shared<OcclusionHiz>()};
}

}  // namespace cullscope::occlusion
