#include "core/visibility/small_feature/level_of_detail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/message.h"
#include "core/spatial/detail_levels.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::small_feature {
namespace {

constexpr const char* kError = "error";
constexpr const char* kHysteresis = "hysteresis";
constexpr const char* kMoveFigure = "surfaces_move_at_most_px";

/// The lines of the listing (detailListing).
enum class DetailLine : uint8_t { Planes = 1, Outside, Level, Stays, Draw };

constexpr OctreeWalkLines kDetailLines{.groupPlanes = uint8_t(DetailLine::Planes),
                                       .groupAxes = uint8_t(DetailLine::Planes),
                                       .groupOutside = uint8_t(DetailLine::Outside),
                                       .groupInside = uint8_t(DetailLine::Draw),
                                       .objectTests = uint8_t(DetailLine::Planes),
                                       .objectOutside = uint8_t(DetailLine::Outside)};

/// By how much a transform stretches a length, at most: its largest singular value, from above by the row sums of MᵀM.
double largestStretch(const Mat4& transform) {
    const Mat3 linear(transform), squared = glm::transpose(linear) * linear;
    double largest = 0.0;
    for (int row = 0; row < 3; ++row)
        largest = std::max(largest, std::abs(squared[0][row]) + std::abs(squared[1][row]) + std::abs(squared[2][row]));
    return std::sqrt(largest);
}

struct LeveledObjects : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    DetailLevels levels;
    std::vector<double> stretch;  ///< by instance: of a length in its mesh
};

struct LevelMemory : ViewState {
    static constexpr uint8_t kNone = 0xFF;

    LastFailedPlanes planes;
    std::vector<uint8_t> level;  ///< by instance: with which it was last drawn; kNone: it was not

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<LevelMemory>(*this); }
};

/// One frame.
class DetailFrame {
public:
    using Levels = std::span<const DetailLevels::Level>;

    DetailFrame(FrameContext& frame, const LeveledObjects& objects, LevelMemory& memory, const ParameterSet& parameters)
        : m_frame(frame),
          m_objects(objects),
          m_memory(memory),
          m_error(parameters.real(kError)),
          m_hysteresis(parameters.real(kHysteresis)) {
        const Frustum& frustum = frame.view().frustum();
        const double unitAhead = 0.5 * frame.view().viewport().height / frustum.halfHeightAt(1.0);
        // Toward a corner of the picture a step along the line of sight's depth moves its point, too.
        m_pixels = unitAhead *
                   std::sqrt(1.0 + frustum.tanHalfWidth * frustum.tanHalfWidth + frustum.tanHalfHeight * frustum.tanHalfHeight);
    }

    [[nodiscard]] DrawList listed() {
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("groups of objects"));
            OctreeWalkOptions options{.refine = true, .memory = &m_memory.planes, .lines = kDetailLines, .visited = {}};
            kept = keptObjects(m_objects.octree, m_frame, &m_walked, options);
        }
        const StageTimer stage(m_frame, CULLSCOPE_TR("draw list"));
        sortNearestFirst(kept, scene(), m_frame.view().eye());
        DrawList list{m_frame.facing(), {}, m_objects.levels.order()};
        for (const KeptObject& object : kept) {
            const uint32_t mesh = scene().instances()[object.instance].mesh;
            const Levels levels = m_objects.levels.of(mesh);
            const uint8_t level = levelOf(object.instance, levels);
            list.ranges.push_back({object.instance, levels[level].firstIndex, levels[level].indexCount});
            if (level > 0) {
                list.grain = Grain::Object;
                ++m_coarser;
            }
            if (m_frame.recording())
                m_frame.say(atLine(DetailLine::Draw, ending(Subject::ofObject(object.instance), Decision::Outcome::Drawn)));
        }
        count();
        return list;
    }

private:
    [[nodiscard]] const Scene& scene() const { return m_frame.scene(); }

    /// By how many pixels a length at an object may move what is seen of it, at most; infinity where the object is not wholly
    /// beyond the near plane.
    [[nodiscard]] double pixelsOf(uint32_t instance) const {
        const EyeBounds bounds = boundsFromEye(scene(), instance, m_frame.view().eye());
        const double nearest =
            glm::dot(m_frame.view().frustum().forward, bounds.sphere.centre) - bounds.sphere.radius - bounds.margin;
        if (!(nearest >= m_frame.view().camera().nearDistance)) return std::numeric_limits<double>::infinity();
        return m_pixels * m_objects.stretch[instance] / (m_frame.view().frustum().parallel() ? 1.0 : nearest);
    }

    /// The coarsest level that moves nothing by more than so many pixels; with 0 the mesh itself, for its depths have the same
    /// bits.
    [[nodiscard]] static uint8_t coarsest(Levels levels, double pixels, double most) {
        size_t level = 0;
        while (most > 0.0 && level + 1 < levels.size() && levels[level + 1].error * pixels <= most) ++level;
        return uint8_t(std::min<size_t>(level, LevelMemory::kNone - 1));
    }

    [[nodiscard]] uint8_t levelOf(uint32_t instance, Levels levels) {
        const double pixels = pixelsOf(instance);
        uint8_t& last = m_memory.level[instance];
        const uint8_t wanted = coarsest(levels, pixels, m_error);
        uint8_t level = wanted;
        if (last != LevelMemory::kNone && wanted > last)
            level = std::max(last, coarsest(levels, pixels, (1.0 - m_hysteresis) * m_error));
        const double move = level == 0 ? 0.0 : levels[level].error * pixels;
        if (m_frame.recording()) sayLevel(instance, levels, level, move, wanted, pixels);
        if (last != LevelMemory::kNone && last != level) ++m_switched;
        last = level;
        m_move = std::max(m_move, move);
        return level;
    }

    void sayLevel(uint32_t instance, Levels levels, uint8_t level, double move, uint8_t wanted, double pixels) {
        Decision test;
        test.subject = Subject::ofObject(instance);
        test.containment = Containment::Inside;
        test.sentence = CULLSCOPE_TR("Of its levels 0 to %1, level %2 moves its surface by at most %3 of %4 pixels.");
        test.operands = {double(levels.size() - 1), double(level), move, m_error};
        test.operandCount = 4;
        m_frame.say(atLine(DetailLine::Level, test));
        if (wanted == level) return;
        test.sentence = CULLSCOPE_TR("Level %1 would do with %2 pixels; it changes to a coarser level only below %3.");
        test.operands = {double(level + 1), levels[size_t(level) + 1].error * pixels, (1.0 - m_hysteresis) * m_error};
        test.operandCount = 3;
        m_frame.say(atLine(DetailLine::Stays, test));
    }

    void count() {
        FrameCounters& counted = m_frame.counters();
        counted.culledTriangles[size_t(Cause::OutsideFrustum)] = m_walked.trianglesCulled;
        counted.nodesVisited = m_walked.nodesVisited + m_walked.objectsTested;
        counted.bytesTouched = m_walked.nodesVisited * sizeof(InstanceOctree::Node) + m_walked.objectsTested * sizeof(Box3);
        counted.figures = {{"plane_tests", double(m_walked.planesTested)},
                           {"objects_at_coarser_levels", double(m_coarser)},
                           {"levels_switched", double(m_switched)},
                           {kMoveFigure, m_move}};
    }

    FrameContext& m_frame;
    const LeveledObjects& m_objects;
    LevelMemory& m_memory;
    double m_error, m_hysteresis;
    double m_pixels = 0.0;  ///< by how many a unit at a depth of 1, or at any one of a parallel view, moves what is seen, at most
    OctreeWalkCounters m_walked;
    uint64_t m_coarser = 0, m_switched = 0;
    double m_move = 0.0;
};

class LevelOfDetail final : public StrategyWith<LeveledObjects, LevelMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        const size_t objects = structure.scene().instances().size();
        auto memory = std::make_unique<LevelMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), objects);
        memory->level.assign(objects, LevelMemory::kNone);
        return memory;
    }
    [[nodiscard]] std::string frameLine(const Structure& /*structure*/, const FrameLog& log) const override {
        for (const NamedFigure& figure : log.counters.figures)
            if (figure.name == kMoveFigure) {
                std::array<char, 64> line{};
                (void)std::snprintf(line.data(), line.size(), "moves surfaces by at most %.3g pixels", figure.value);
                return line.data();
            }
        return {};
    }

protected:
    void fill(LeveledObjects& objects, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = objects.scene();
        objects.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
        objects.levels = DetailLevels(scene, progress);
        for (const Instance& instance : scene.instances()) objects.stretch.push_back(largestStretch(instance.worldFromMesh));
        // With the memory of one view.
        objects.report.bytes = objects.octree.bytes() + objects.levels.bytes() + objects.stretch.size() * (sizeof(double) + 1) +
                               LastFailedPlanes(objects.octree.nodes().size(), scene.instances().size()).bytes();
        objects.report.figures = {{"objects", double(objects.octree.order().size())},
                                  {"meshes", double(scene.meshes().size())},
                                  {"meshes with levels by segments", double(objects.levels.meshesBySegments())},
                                  {"meshes with levels by quadrics", double(objects.levels.meshesByQuadrics())},
                                  {"coarser levels", double(objects.levels.coarserLevels())}};
    }

    void decide(FrameContext& frame, const LeveledObjects& objects, LevelMemory& memory,
                const ParameterSet& parameters) const override {
        frame.draw(DetailFrame(frame, objects, memory, parameters).listed());
    }

    [[nodiscard]] Promise promiseOf(const LeveledObjects& /*objects*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.real(kError) == 0.0 ? Promise::Conservative : Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const LeveledObjects& objects, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, objects.scene());
        addGroups(result, objects.octree, objects.scene(), log);
        result.objectSentence = CULLSCOPE_TR("The object \"%1\" has %2 triangles; far away, a coarser level stands for it.");
        return result;
    }
};

Show detailListing() {
    return listingShow({{CULLSCOPE_TR("for each group: planes and axes"), 0},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("k = coarsest: e·f ÷ z ≤ error"), 1},
                        {CULLSCOPE_TR("coarser than last: ≤ (1−h)·error"), 1},
                        {CULLSCOPE_TR("draw level k, nearest first"), 0}});
}

}  // namespace

RegisteredStrategy levelOfDetail() {
    ParameterDeclaration error{kError,
                               ParameterType::Real,
                               1.0,
                               0.0,
                               1000.0,
                               "px",
                               CULLSCOPE_TR("By how many pixels a coarser level may move an object's surface in the picture."),
                               {}};
    ParameterDeclaration hysteresis{kHysteresis,
                                    ParameterType::Real,
                                    0.25,
                                    0.0,
                                    0.95,
                                    "",
                                    CULLSCOPE_TR("By what share of these pixels a coarser level must stay below them before an "
                                                 "object changes to it: against popping."),
                                    {}};
    StrategyInfo info{"level-of-detail",
                      CULLSCOPE_TR("Level of detail"),
                      CULLSCOPE_TR("Draws far objects with fewer triangles, whose surfaces move by a bounded number of pixels."),
                      "Cullscope; Garland & Heckbert 1997",
                      {facingParameter(), error, hysteresis}};
    info.remembers = true;
    info.sweeps = {{kError, {"0", "0.25", "0.5", "1", "2", "4", "8"}}};
    info.shows = {detailListing(), treeShow()};
    return {std::move(info), std::make_shared<LevelOfDetail>()};
}

}  // namespace cullscope::small_feature
