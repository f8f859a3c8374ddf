#include "core/visibility/occlusion/occlusion_hiz.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/base/work_check.h"
#include "core/spatial/part_boxes.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/hiz_groups.h"
#include "core/visibility/occlusion/query_octree.h"
#include "core/visibility/occlusion/two_passes.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kRounds = "rounds";
constexpr const char* kLarge = "large";
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
    std::vector<uint32_t> leaves;  ///< by object
    std::vector<float> largest;    ///< by node
    PartBoxes parts;
};

struct HizMemory : ViewState {
    LastFailedPlanes planes;
    LastVisible last;
    ShownGroups shown;

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
        using enum Decision::Outcome;
        using enum Subject::Kind;
        const auto count = [&](HizLine line, Decision::Outcome outcome, Subject::Kind kind = Object) {
            return uint64_t(std::ranges::count_if(log.decisions, [&](const Decision& decision) {
                return decision.line == uint8_t(line) && decision.outcome == outcome && decision.subject.kind == kind;
            }));
        };
        return {{},
                {{CULLSCOPE_TR("groups hidden"), count(HizLine::Hidden, Culled, Node), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects drawn first"), count(HizLine::First, Drawn), TriangleState::Visible},
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
        structure.leaves = leavesOfObjects(structure.octree, scene.instances().size());
        structure.largest = largestOfNodes(structure.octree, scene);
        structure.parts = PartBoxes(scene, progress);
        structure.report.bytes = structure.octree.bytes() + structure.leaves.size() * sizeof(uint32_t) +
                                 structure.largest.size() * sizeof(float) + structure.parts.bytes();
        uint64_t boxes = 0;
        for (uint32_t i = 0; i < scene.instances().size(); ++i) boxes += std::max<size_t>(structure.parts.of(i).size(), 1);
        structure.report.figures = {{"objects", double(scene.instances().size())},
                                    {"nodes", double(structure.octree.nodes().size())},
                                    {"boxes", double(boxes)}};
    }

    void decide(FrameContext& frame, const HizOctree& structure, HizMemory& memory,
                const ParameterSet& parameters) const override {
        const StageTimer stage(frame, CULLSCOPE_TR("walk and pyramid"));
        HizGroups groups(structure.octree, structure.largest, frame,
                         {.large = size_t(parameters.integer(kLarge)),
                          .lines = {kHizWalkLines, uint8_t(HizLine::Hidden)},
                          .planes = &memory.planes},
                         nodesAround(memory.last.visible(frame), structure.leaves, structure.octree), memory.shown);
        DrawnParts parts(frame.view());
        const auto add = [&](std::vector<KeptObject> kept) {
            sortNearestFirst(kept, frame.scene(), frame.view().eye());
            addParts(parts, frame, structure, kept);
        };
        add(groups.begin());
        TwoPassOptions options{.rounds = size_t(parameters.integer(kRounds)), .lines = kHizLines, .like = {frame.facing(), {}}};
        if (groups.waiting())
            options.others = [&](SecondPass& pass) {
                pass.draw();
                add(groups.ask(pass));
            };
        const TwoPassCounters counted = drawInTwoPasses(frame, parts, options, memory.last);
        count(frame, counted, groups.counters());
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
    static void count(FrameContext& frame, const TwoPassCounters& counted, const HizGroupCounters& groups) {
        FrameCounters& counters = frame.counters();
        counters.culledTriangles[size_t(Cause::OutsideFrustum)] = groups.walked.trianglesCulled;
        counters.nodesVisited = groups.walked.nodesVisited + groups.walked.objectsTested;
        counters.bytesTouched = groups.walked.nodesVisited * sizeof(InstanceOctree::Node) +
                                groups.walked.objectsTested * sizeof(Box3) + counted.boxes * sizeof(Box3);
        counters.workBytes = counted.pyramids > 0 ? pyramidBytes(frame.view().viewport()) : 0;
        counters.figures = {{"first_objects", double(counted.first)},       {"tested_groups", double(counted.groups)},
                            {"hidden_groups", double(groups.hiddenGroups)}, {"tested_objects", double(counted.tested)},
                            {"tested_boxes", double(counted.boxes)},        {"pyramids", double(counted.pyramids)}};
    }

    /// The objects with triangles, by the boxes of their parts, or by their own.
    static void addParts(DrawnParts& parts, const FrameContext& frame, const HizOctree& structure,
                         const std::vector<KeptObject>& kept) {
        const Progress progress{nullptr, frame.stop()};
        WorkCheck work(progress);
        const Scene& scene = frame.scene();
        for (const auto& [instance, planes] : kept) {
            const auto indices = uint32_t(scene.meshOf(instance).indices().size());
            if (indices == 0) continue;
            const Sphere& sphere = scene.instanceSphere(instance);
            parts.add(instance, Subject::ofObject(instance), {instance, 0, indices}).distance =
                glm::length(sphere.centre - frame.view().eye()) - sphere.radius;
            const std::span<const Box3> smaller = structure.parts.of(instance);
            for (const Box3& box : smaller.empty() ? std::span(&scene.instanceBox(instance), 1) : smaller) {
                for (int step = 0; step < kStepsOfABox; ++step) work.step();
                parts.addBox(grownBox(box, frame.view()));
            }
        }
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
                                     "draws hides what the next one tests.")),
         wholeParameter(kLarge, 128, 0, 1e9,
                        CULLSCOPE_TR("How many objects of which nothing is known are tested before groups are, those that look "
                                     "largest: what they hide is left out by groups."))},
        GlRequirement::Context};
    info.remembers = true;
    info.sweeps = {{kRounds, {"1", "2", "3", "4", "6"}}, {kLarge, {"0", "32", "128", "512", "1000000000"}}};
    info.shows = {treeShow(), hizListing(), barsShow("pyramid-objects", CULLSCOPE_TR("Objects by the depth pyramid"))};
    return {std::move(info), std::make_shared<OcclusionHiz>()};
}

}  // namespace cullscope::occlusion
