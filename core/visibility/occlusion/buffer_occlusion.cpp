#include "core/visibility/occlusion/buffer_occlusion.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/frame/named_parts.h"
#include "core/gpu/colour.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/buffer_walk.h"
#include "core/visibility/occlusion/occluder_parameters.h"
#include "core/visibility/overlay.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kOccluders = "occluders";
constexpr float kOccluderWidth = 1.0f;  // units

/// The lines of the listing (bufferListing).
enum class BufferLine : uint8_t { Visit = 1, Frustum, Outside, Ask, Hidden, Parts, Object, Occlude, AskAgain, Draw };

constexpr BufferLines kBufferLines{.walk = {.groupPlanes = uint8_t(BufferLine::Frustum),
                                            .groupAxes = uint8_t(BufferLine::Frustum),
                                            .groupOutside = uint8_t(BufferLine::Outside),
                                            .groupInside = uint8_t(BufferLine::Parts),
                                            .objectTests = uint8_t(BufferLine::Object),
                                            .objectOutside = uint8_t(BufferLine::Outside)},
                                   .group = uint8_t(BufferLine::Ask),
                                   .object = uint8_t(BufferLine::Object),
                                   .hidden = uint8_t(BufferLine::Hidden),
                                   .occlude = uint8_t(BufferLine::Occlude),
                                   .again = uint8_t(BufferLine::AskAgain)};

struct OccluderOctree : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    Occluders occluders;
    PartBoxes parts;
};

struct BufferMemory : ViewState {
    explicit BufferMemory(OcclusionForm form) : buffer(form) {}

    /// The buffer begins anew with every frame: only its memory is kept.
    [[nodiscard]] ViewStatePointer clone() const override {
        auto copy = std::make_unique<BufferMemory>(buffer.form());
        static_cast<ViewState&>(*copy) = *this;
        copy->planes = planes;
        return copy;
    }

    LastFailedPlanes planes;
    OcclusionBuffer buffer;
};

class BufferOcclusion final : public StrategyWith<OccluderOctree, BufferMemory> {
public:
    explicit BufferOcclusion(OcclusionForm form) : m_form(form) {}

    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<BufferMemory>(m_form);
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }

    /// Counts of what was decided at each end.
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto count = [&](BufferLine line, Subject::Kind kind) {
            return uint64_t(std::ranges::count_if(log.decisions, [&](const Decision& decision) {
                return decision.line == uint8_t(line) && decision.subject.kind == kind;
            }));
        };
        using enum Subject::Kind;
        return {{},
                {{CULLSCOPE_TR("groups hidden"), count(BufferLine::Hidden, Node), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects hidden one by one"), count(BufferLine::Hidden, Object), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects that occlude"), count(BufferLine::Occlude, Object)},
                 {CULLSCOPE_TR("objects drawn"), count(BufferLine::Draw, Object), TriangleState::Visible}}};
    }

    [[nodiscard]] NamedParts partsByLeaf(const Structure& structure, const FrameLog& /*log*/) const override {
        return objectsByLeaf(own(structure).octree, structure.scene());
    }

    /// The edges of the triangles that were drawn into the buffer.
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view /*id*/, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const override {
        // Hidden by what lies before them: from the culling eye occluders are in front, and thousands of edges would cover all.
        OverlayLines edges{{}, {kOccluderWidth, true}};
        for (const Decision& decision : log.decisions)
            if (decision.line == uint8_t(BufferLine::Occlude))
                addEdges(edges, own(structure), decision.subject.number, size_t(decision.operands[0]), context.contrast);
        if (edges.lines.empty()) return {};
        return {std::move(edges)};
    }

protected:
    void fill(OccluderOctree& structure, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
        structure.occluders = Occluders(scene, progress);
        structure.parts = PartBoxes(scene, progress);
        structure.report.bytes = structure.octree.bytes() + structure.occluders.bytes() + structure.parts.bytes();
        uint64_t triangles = 0;
        for (const OccluderMesh& mesh : structure.occluders.meshes) triangles += mesh.count();
        structure.report.figures = {{"objects", double(scene.instances().size())},
                                    {"nodes", double(structure.octree.nodes().size())},
                                    {"occluder_triangles", double(triangles)}};
    }

    void decide(FrameContext& frame, const OccluderOctree& structure, BufferMemory& memory,
                const ParameterSet& parameters) const override {
        BufferCounters counted;
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(frame, CULLSCOPE_TR("walk and occluders"));
            kept =
                walkWithBuffer(structure.octree, structure.occluders, structure.parts, frame,
                               {parameters.real(kOccluderPixels), uint64_t(parameters.integer(kOccluderTriangles)), kBufferLines},
                               memory.planes, memory.buffer, counted);
        }
        DrawList list{frame.facing(), {}};
        for (const KeptObject& object : kept) {
            list.ranges.push_back({object.instance, 0, uint32_t(frame.scene().meshOf(object.instance).indices().size())});
            if (frame.recording())
                frame.say(atLine(BufferLine::Draw, ending(Subject::ofObject(object.instance), Decision::Outcome::Drawn)));
        }
        FrameCounters& counters = frame.counters();
        counters.culledTriangles[size_t(Cause::OutsideFrustum)] = counted.walk.trianglesCulled;
        counters.culledTriangles[size_t(Cause::Hidden)] = counted.hiddenTriangles;
        counters.nodesVisited = counted.walk.nodesVisited + counted.walk.objectsTested;
        counters.bytesTouched =
            counted.walk.nodesVisited * sizeof(InstanceOctree::Node) + counted.walk.objectsTested * sizeof(Box3);
        counters.workBytes = memory.buffer.empty() ? 0 : memory.buffer.bytes();
        counters.figures = {{"occluders", double(counted.occluders)},
                            {"occluder_triangles", double(memory.buffer.counts().given)},
                            {"questions", double(counted.questions)},
                            {"hidden_nodes", double(counted.hiddenNodes)},
                            {"hidden_objects", double(counted.hiddenObjects)}};
        frame.draw(std::move(list));
    }

    [[nodiscard]] Promise promiseOf(const OccluderOctree& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const OccluderOctree& structure, const FrameLog& log) const override {
        StructureSnapshot tree = objectNodes(log, structure.scene());
        tree.objectSentence = CULLSCOPE_TR("The object \"%1\" lies in a box of the octree; it has %2 triangles.");
        tree.groupSentence = CULLSCOPE_TR("It lies in a group of %1 objects, whose box no occluder hides.");
        addGroups(tree, structure.octree, structure.scene(), log);
        return tree;
    }

private:
    static void addEdges(OverlayLines& edges, const OccluderOctree& structure, uint32_t instance, size_t count,
                         const Vec3f& colour) {
        const Scene& scene = structure.scene();
        const OccluderMesh& mesh = structure.occluders.meshes[scene.instances()[instance].mesh];
        const Mat4& placed = scene.instances()[instance].worldFromMesh;
        const auto corner = [&](size_t i) {
            return Vec3(placed * Vec4(scene.meshOf(instance).origin() + Vec3(mesh.positions[mesh.indices[i]]), 1.0));
        };
        for (size_t triangle = 0; triangle < std::min(count, mesh.count()); ++triangle)
            for (size_t i = 0; i < 3; ++i)
                edges.lines.push_back({corner(3 * triangle + i), corner(3 * triangle + (i + 1) % 3), colour});
    }

    OcclusionForm m_form;
};

Message noOccluders(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" draws no occluders. Drawing some: %3.", {option, strategy, having}};
}

Show occludersShow() {
    Show show;
    show.id = kOccluders;
    show.help = "of occlusion-depth and occlusion-masked: the triangles that were drawn into the buffer";
    show.title = CULLSCOPE_TR("Occluders");
    show.action = CULLSCOPE_TR("&Occluders");
    show.explanation = CULLSCOPE_TR("Show in the active view which triangles hide what lies behind them");
    show.meanings = {{CULLSCOPE_TR("drawn as an occluder"), contrastTo}};
    show.absent = noOccluders;
    return show;
}

Show bufferListing() {
    return listingShow({{CULLSCOPE_TR("visit(group, planes that may cut it)"), 0},
                        {CULLSCOPE_TR("test its box against the frustum"), 1},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("ask the buffer: is its box hidden?"), 1},
                        {CULLSCOPE_TR("yes: hidden, leave all its objects out"), 1},
                        {CULLSCOPE_TR("no: visit(parts), nearest first"), 1},
                        {CULLSCOPE_TR("an object: test and ask likewise"), 2},
                        {CULLSCOPE_TR("not hidden: put it into the buffer"), 2},
                        {CULLSCOPE_TR("ask again about each object kept"), 0},
                        {CULLSCOPE_TR("draw the others, nearest first"), 0}});
}

RegisteredStrategy withBuffer(OcclusionForm form, StrategyInfo info) {
    info.parameters = {facingParameter(), occluderPixelsParameter(), occluderTrianglesParameter()};
    info.sweeps = {occluderPixelsSweep(), occluderTrianglesSweep()};
    info.shows = {occludersShow(), treeShow(), bufferListing(), barsShow("hidden-objects", CULLSCOPE_TR("What occluders hid"))};
    return {std::move(info), std::make_shared<BufferOcclusion>(form)};
}

}  // namespace

RegisteredStrategy occlusionDepth() {
    return withBuffer(
        OcclusionForm::Depth,
        {"occlusion-depth",
         CULLSCOPE_TR("Occlusion by a depth buffer in software"),
         CULLSCOPE_TR("Draws the largest triangles of near objects into a depth buffer on the processor, and leaves "
                      "out what lies behind them."),
         "",
         {}});
}

RegisteredStrategy occlusionMasked() {
    return withBuffer(
        OcclusionForm::Masked,
        {"occlusion-masked",
         CULLSCOPE_TR("Masked occlusion in software"),
         CULLSCOPE_TR("As occlusion by a depth buffer, with two depths and a mask for 32 pixels: much faster, and hides "
                      "nearly as much."),
         "Hasselgren, Andersson & Akenine-Möller 2016",
         {}});
}

}  // namespace cullscope::occlusion
