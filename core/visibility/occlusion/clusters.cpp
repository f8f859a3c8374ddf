#include "core/visibility/occlusion/clusters.h"

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/cluster_frame.h"
#include "core/visibility/occlusion/occluder_parameters.h"
#include "core/visibility/overlay.h"
#include "core/visibility/triangles_by_test.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kCones = "cones";
constexpr const char* kSamples = "samples";
constexpr const char* kOcclusion = "occlusion";
constexpr const char* kDepth = "depth";
constexpr const char* kMasked = "masked";
constexpr const char* kPyramid = "hiz";
constexpr const char* kClusterBoxes = "clusters";

class Clusters final : public StrategyWith<ClusterScene, ClusterMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<ClusterMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return trianglesByTest(log, structure.scene(), CULLSCOPE_TR("occluders"));
    }

    /// The boxes of the nodes at which the walks ended, by what became of them.
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view /*id*/, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const override {
        OverlayLines boxes{{}, {kBoxLineWidth, true}};
        for (const Decision& decision : log.decisions) {
            if (decision.subject.kind != Subject::Kind::Cell || decision.outcome == Decision::Outcome::Open) continue;
            const TriangleState state =
                decision.outcome == Decision::Outcome::Culled ? stateOfCause(decision.cause) : TriangleState::Visible;
            addNodeBox(boxes, own(structure), decision.subject, context.palette[size_t(state)].colour);
        }
        return {std::move(boxes)};
    }

protected:
    void fill(ClusterScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.clusters = SceneClusters(scene, uint32_t(parameters.integer(kClusterSize)), progress.part(0.0, 0.9));
        if (parameters.boolean(kSamples)) structure.corners = cornersOf(scene, structure.clusters);
        structure.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
        structure.occluders = Occluders(scene, progress);
        structure.parts = PartBoxes(scene, progress);
        uint64_t cornerBytes = 0;
        for (const CornerBlocks& corners : structure.corners) cornerBytes += corners.bytes();
        structure.report.bytes = structure.clusters.bytes() + cornerBytes + structure.octree.bytes() +
                                 structure.occluders.bytes() + structure.parts.bytes();
        structure.report.figures = structure.clusters.figures();
        structure.report.figures.insert(structure.report.figures.begin(), {{"objects", double(scene.instances().size())},
                                                                           {"groups", double(structure.octree.nodes().size())}});
        structure.report.figures.push_back({"cluster bytes", double(structure.clusters.bytes())});
        structure.report.figures.push_back({"corner bytes", double(cornerBytes)});
        structure.report.figures.push_back({"octree bytes", double(structure.octree.bytes())});
        structure.report.figures.push_back({"occluder bytes", double(structure.occluders.bytes() + structure.parts.bytes())});
    }

    void decide(FrameContext& frame, const ClusterScene& structure, ClusterMemory& memory,
                const ParameterSet& parameters) const override {
        ClusterOptions options{
            parameters.boolean(kCones), {}, parameters.real(kOccluderPixels), uint64_t(parameters.integer(kOccluderTriangles))};
        const std::string& occlusion = parameters.choice(kOcclusion);
        if (occlusion == kDepth) options.occlusion = OcclusionForm::Depth;
        if (occlusion == kMasked) options.occlusion = OcclusionForm::Masked;
        options.pyramid = occlusion == kPyramid;
        options.samples = parameters.boolean(kSamples);
        drawClusters(frame, structure, memory, options);
    }

    [[nodiscard]] Promise promiseOf(const ClusterScene& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }

    [[nodiscard]] StructureSnapshot snapshotOf(const ClusterScene& structure, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, structure.scene());
        result.objectSentence =
            CULLSCOPE_TR("The object \"%1\" is tested as one box, then by its clusters; it has %2 triangles.");
        addGroups(result, structure.octree, structure.scene(), log);
        return result;
    }

private:
    /// The corners of triangles as their tests read them; of small meshes, which are not cut, in the mesh's order.
    static std::vector<CornerBlocks> cornersOf(const Scene& scene, const SceneClusters& clusters) {
        std::vector<CornerBlocks> corners(scene.meshes().size());
        for (size_t i = 0; i < corners.size(); ++i) {
            if (!clusters.meshes[i]) continue;
            const std::span<const uint32_t> inOrder = clusters.meshes[i]->indices();
            corners[i] = CornerBlocks(*scene.meshes()[i], inOrder.empty() ? scene.meshes()[i]->indices() : inOrder);
        }
        return corners;
    }

    /// The box of a node, which is level in its mesh and may be turned in the world.
    static void addNodeBox(OverlayLines& boxes, const ClusterScene& structure, const Subject& subject, const Vec3f& colour) {
        const Scene& scene = structure.scene();
        const ClusterTree& tree = structure.clusters.of(scene, subject.object);
        const SurfaceNode& node = tree.nodes()[subject.number];
        const Vec3 centre = tree.mesh().origin() + tree.sphere().centre;
        const auto corner = [&](int c) {
            const Vec3 local((c & 1) != 0 ? node.high.x : node.low.x, (c & 2) != 0 ? node.high.y : node.low.y,
                             (c & 4) != 0 ? node.high.z : node.low.z);
            return Vec3(scene.instances()[subject.object].worldFromMesh * Vec4(centre + local, 1.0));
        };
        addBoxEdges(boxes, corner, colour);
    }
};

Message noClusters(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no clusters. Having them: %3.", {option, strategy, having}};
}

Show clusterBoxes() {
    Show show;
    show.id = kClusterBoxes;
    show.help = "of clusters: the boxes at which the walk over each object's clusters ended, by what became of them";
    show.title = CULLSCOPE_TR("Boxes of clusters");
    show.action = CULLSCOPE_TR("Boxes of cl&usters");
    show.explanation = CULLSCOPE_TR(
        "Show in the active view the boxes of the clusters, or of groups of them that were decided together, by what became of "
        "them");
    show.absent = noClusters;
    return show;
}

Show clusterListing() {
    return listingShow({{CULLSCOPE_TR("test groups, objects by planes"), 0},
                        {CULLSCOPE_TR("outside: leave it all out"), 1},
                        {CULLSCOPE_TR("hidden by nearer ones: leave it out"), 1},
                        {CULLSCOPE_TR("else it occludes those behind it"), 1},
                        {CULLSCOPE_TR("walk(each object); if open, its parts"), 0},
                        {CULLSCOPE_TR("box outside: leave it out"), 1},
                        {CULLSCOPE_TR("faces away: leave it out"), 1},
                        {CULLSCOPE_TR("box hidden: leave it out"), 1},
                        {CULLSCOPE_TR("no test open, leaf, gap: draw"), 1},
                        {CULLSCOPE_TR("few pixels: triangle by triangle"), 1}});
}

}  // namespace

RegisteredStrategy clusters() {
    StrategyInfo info{
        "clusters",
        CULLSCOPE_TR("Clusters of triangles"),
        CULLSCOPE_TR("Cuts meshes into clusters of neighbouring triangles and tests these, from large groups to "
                     "single ones, against the frustum, by the cones of their normals and by what lies before "
                     "them: loses nothing on any mesh."),
        "Shirman & Abi-Ezzi 1993; Hasselgren, Andersson & Akenine-Möller 2016",
        {facingParameter(), clusterSizeParameter(),
         choiceParameter(kOcclusion, kMasked,
                         CULLSCOPE_TR("How it is found that clusters are hidden: by large triangles of near objects, drawn on "
                                      "the processor, or by what the frame has drawn."),
                         {{"none", CULLSCOPE_TR("it is not")},
                          {kDepth, CULLSCOPE_TR("a depth for every pixel")},
                          {kMasked, CULLSCOPE_TR("two depths and a mask for each 8 × 4 pixels")},
                          {kPyramid, CULLSCOPE_TR("a pyramid of the depth that the frame has drawn, on the GPU")}}),
         booleanParameter(kCones, true,
                          CULLSCOPE_TR("Whether clusters whose triangles all face away are left out (where only "
                                       "front sides are drawn).")),
         readWhenBuilding(booleanParameter(
             kSamples, true,
             CULLSCOPE_TR(
                 "Whether triangles that hold no pixel centre or face away are left out of the drawn clusters one by one "
                 "(where the picture has few pixels for each; not with occlusion=hiz)."))),
         occluderPixelsParameter(), occluderTrianglesParameter()}};
    info.remembers = true;
    info.sweeps = {{kClusterSize, {"32", "64", "128", "256", "512"}}, occluderPixelsSweep(), occluderTrianglesSweep()};
    info.shows = {treeShow(), clusterBoxes(), clusterListing(), trianglesByTestShow()};
    return {std::move(info), std::make_shared<Clusters>()};
}

}  // namespace cullscope::occlusion
