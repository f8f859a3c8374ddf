#include "core/visibility/occlusion/pvs.h"

#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "core/base/message.h"
#include "core/gpu/colour.h"
#include "core/spatial/hiding_sheets.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/pvs_build.h"
#include "core/visibility/occlusion/region_outline.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/overlay.h"

namespace cullscope::occlusion {
namespace {

constexpr const char* kSets = "sets";
constexpr const char* kSampled = "sampled";
constexpr const char* kConservative = "conservative";
constexpr const char* kGiven = "given";
constexpr const char* kCells = "cells";
constexpr const char* kHalvings = "halvings";
constexpr const char* kRays = "rays";
constexpr const char* kSeed = "seed";
constexpr const char* kNeighbours = "neighbours";
constexpr const char* kViewCell = "view-cell";
constexpr float kCellWidth = 2.0f;  // units

/// The lines of the listing (pvsListing).
enum class PvsLine : uint8_t { Cell = 1, NoCell, Objects, NotInSet, Test, Outside, Draw };

struct CellSets : Structure {
    using Structure::Structure;
    RegionSetsPointer sets;  ///< null: everything may be seen from everywhere
    bool proven = false;
    SightRoom room;
    Facing facing = Facing::TwoSided;  ///< by what was found
};

/// The set of the cell in which the eye was last.
struct LastCell : ViewState {
    std::optional<uint32_t> region;
    std::vector<uint32_t> objects;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<LastCell>(*this); }
};

/// Why a frame draws all that is in the frustum, as its sentence; null: the cell's set holds.
const char* withoutSet(const FrameContext& frame, const CellSets& structure) {
    if (!structure.sets)
        return CULLSCOPE_TR(
            "The scene has no view cells: it has less than two objects, or too many triangles. Each object may be "
            "visible.");
    if (frame.facing() == Facing::Front && structure.facing != Facing::Front)
        return CULLSCOPE_TR(
            "The sets are made for surfaces that hide from both sides, and this frame draws fronts alone: each "
            "object may be visible.");
    if (!structure.sets->regionAt(frame.view().eye()))
        return CULLSCOPE_TR("The eye lies in no view cell: each object may be visible.");
    if (structure.proven && !structure.room.holds(frame.view()))
        return CULLSCOPE_TR(
            "The near plane or the pixels of this view are beyond what the proofs allow for: each object may be "
            "visible.");
    return nullptr;
}

/// The tests of one frame.
class CellFrame {
public:
    CellFrame(FrameContext& frame, const CellSets& structure) : m_frame(frame), m_structure(structure) {}

    void decide(LastCell& last) {
        const size_t objects = m_frame.scene().instances().size();
        if (const char* reason = withoutSet(m_frame, m_structure)) {
            sayBegin(m_frame, uint8_t(PvsLine::NoCell), reason, {});
            for (uint32_t i = 0; i < objects; ++i) test(i);
            return;
        }
        const uint32_t region = *m_structure.sets->regionAt(m_frame.view().eye());
        if (last.region != region) {
            last.objects = m_structure.sets->objectsOf(region);
            last.region = region;
        }
        sayBegin(m_frame, uint8_t(PvsLine::Cell),
                 CULLSCOPE_TR("The eye lies in view cell %1, from which %2 objects may be seen."),
                 {double(region), double(last.objects.size())});
        if (m_frame.recording()) sayHidden(last.objects);
        uint64_t listed = 0;
        for (const uint32_t object : last.objects) {
            listed += m_frame.scene().meshOf(object).triangleCount();
            test(object);
        }
        m_frame.counters().culledTriangles[size_t(Cause::Hidden)] = m_frame.scene().triangleCount() - listed;
        m_frame.counters().figures.push_back({"set_objects", double(last.objects.size())});
    }

    std::vector<KeptObject> kept;
    uint64_t tested = 0;

private:
    void sayHidden(std::span<const uint32_t> set) {
        for (uint32_t i = 0; i < m_frame.scene().instances().size(); ++i)
            if (m_frame.scene().meshOf(i).triangleCount() > 0 && !std::ranges::binary_search(set, i))
                m_frame.say(atLine(PvsLine::NotInSet, ending(Subject::ofObject(i), Decision::Outcome::Culled, Cause::Hidden)));
    }

    void test(uint32_t object) {
        const uint64_t triangles = m_frame.scene().meshOf(object).triangleCount();
        if (triangles == 0) return;
        ++tested;
        const EyeBounds bounds = boundsFromEye(m_frame.scene(), object, m_frame.view().eye());
        for (uint32_t p = 0; p < kFrustumPlaneCount; ++p) {
            const double inside = farthestInside(m_frame.view().frustum().planes[p], bounds);
            if (m_frame.recording())
                m_frame.say(
                    atLine(PvsLine::Test, outsideTest(Subject::ofObject(object), FrustumPlane(p), inside, bounds.margin)));
            if (inside >= -bounds.margin) continue;
            m_frame.counters().culledTriangles[size_t(Cause::OutsideFrustum)] += triangles;
            if (m_frame.recording())
                m_frame.say(atLine(PvsLine::Outside, ending(Subject::ofObject(object), Decision::Outcome::Culled)));
            return;
        }
        kept.push_back({object, 0});
    }

    FrameContext& m_frame;
    const CellSets& m_structure;
};

class Pvs final : public StrategyWith<CellSets, LastCell> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<LastCell>(); }

    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& /*structure*/, const FrameLog& log) const override {
        const auto count = [&](PvsLine line) {
            return uint64_t(std::ranges::count_if(log.decisions, [&](const Decision& one) { return one.line == uint8_t(line); }));
        };
        return {{},
                {{CULLSCOPE_TR("objects not in the cell's set"), count(PvsLine::NotInSet), TriangleState::Hidden},
                 {CULLSCOPE_TR("objects outside the frustum"), count(PvsLine::Outside), TriangleState::OutsideFrustum},
                 {CULLSCOPE_TR("objects drawn"), count(PvsLine::Draw), TriangleState::Visible}}};
    }

    /// The edges of the cell in which the culling eye lies.
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view /*id*/, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const override {
        const CellSets& cells = own(structure);
        const std::optional<uint32_t> region = cells.sets ? cells.sets->regionAt(log.camera.eye) : std::nullopt;
        if (!region) return {};
        OverlayLines edges{{}, {kCellWidth, false}, true};
        const Box3& box = cells.sets->within().empty() ? structure.scene().bounds() : cells.sets->within();
        for (const auto& [from, to] : regionOutline(*cells.sets, *region, box))
            edges.lines.push_back({from, to, context.contrast});
        if (edges.lines.empty()) return {};
        return {std::move(edges)};
    }
    [[nodiscard]] std::optional<Message> whyNotShown(std::string_view id, std::string_view colouring, const Structure& structure,
                                                     const FrameLog& log) const override {
        if (id != kViewCell) return StrategyWith::whyNotShown(id, colouring, structure, log);
        const CellSets& cells = own(structure);
        if (cells.sets && cells.sets->regionAt(log.camera.eye)) return std::nullopt;
        return Message{CULLSCOPE_TR("The culling eye lies in no view cell."), {}};
    }

protected:
    void fill(CellSets& structure, const ParameterSet& parameters, const Progress& progress) const override {
        const Scene& scene = structure.scene();
        structure.room = SightRoom(scene);
        structure.facing = facingByObject(scene);
        structure.report.figures = {{"objects", double(scene.instances().size())}};
        if (parameters.choice(kSets) == kGiven) {
            structure.sets = scene.remarks().visibility;
            if (!structure.sets)
                throwUsage(
                    CULLSCOPE_TR("sets=%1: the scene came without potentially visible sets, which levels of Quake 3 (.bsp) "
                                 "have. Take %2 or %3."),
                    {kGiven, kSampled, kConservative});
        } else {
            find(structure, parameters, progress);
        }
        if (structure.sets) report(structure);
    }

    void decide(FrameContext& frame, const CellSets& structure, LastCell& last,
                const ParameterSet& /*parameters*/) const override {
        DrawList list{frame.facing(), {}};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("the cell's set"));
            CellFrame cell(frame, structure);
            cell.decide(last);
            sortNearestFirst(cell.kept, frame.scene(), frame.view().eye());
            for (const KeptObject& object : cell.kept) {
                list.ranges.push_back({object.instance, 0, uint32_t(frame.scene().meshOf(object.instance).indices().size())});
                if (frame.recording())
                    frame.say(atLine(PvsLine::Draw, ending(Subject::ofObject(object.instance), Decision::Outcome::Drawn)));
            }
            frame.counters().nodesVisited = cell.tested;
            frame.counters().bytesTouched = cell.tested * (sizeof(Box3) + sizeof(Sphere));
        }
        frame.draw(std::move(list));
    }

    [[nodiscard]] Promise promiseOf(const CellSets& structure, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return structure.proven || !structure.sets ? Promise::Conservative : Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const CellSets& structure, const FrameLog& log) const override {
        StructureSnapshot tree = objectNodes(log, structure.scene());
        tree.objectSentence =
            CULLSCOPE_TR("The object \"%1\" has %2 triangles, which the cell's set has together or not at all.");
        return tree;
    }

private:
    static void find(CellSets& structure, const ParameterSet& parameters, const Progress& progress) {
        structure.proven = parameters.choice(kSets) == kConservative;
        PvsOptions options;
        options.cells = {int(parameters.integer(kCells)), int(parameters.integer(kHalvings))};
        options.rays = uint64_t(parameters.integer(kRays));
        options.seed = uint64_t(parameters.integer(kSeed));
        options.proven = structure.proven;
        // A proof adds by itself what rays have missed.
        options.neighbours = !structure.proven && parameters.boolean(kNeighbours);
        std::optional<BuiltSets> built = buildSets(structure.scene(), options, progress);
        if (!built) return;
        structure.report.figures.push_back({"rays", double(built->rays)});
        const double pairs = double(built->cells.boxes.size()) * double(structure.scene().instances().size());
        structure.report.figures.push_back({"seen_share", double(built->seen) / pairs});
        if (structure.proven) {
            structure.report.figures.push_back({"proven_share", double(built->proven) / pairs});
            structure.report.figures.push_back({"unproven_share", double(built->unproven) / pairs});
        }
        structure.sets = std::make_shared<const RegionSets>(std::move(built->sets));
    }
    static void report(CellSets& structure) {
        const RegionSets& sets = *structure.sets;
        structure.report.bytes = sets.bytes();
        double cells = 0.0, objects = 0.0;
        for (uint32_t region = 0; region < sets.regionCount(); ++region) {
            if (!sets.hasSet(region)) continue;
            cells += 1.0;
            objects += double(sets.objectsOf(region).size());
        }
        structure.report.figures.push_back({"cells", cells});
        structure.report.figures.push_back({"sets", double(sets.setCount())});
        if (cells == 0.0) return;
        structure.report.figures.push_back({"objects_in_set", objects / cells});
        structure.report.figures.push_back({"bytes_per_cell", double(sets.bytes()) / cells});
    }
};

Message noCell(const std::string& option, const std::string& strategy, const std::string& having) {
    return {"%1: the strategy \"%2\" has no view cells. Having some: %3.", {option, strategy, having}};
}

Show viewCellShow() {
    Show show;
    show.id = kViewCell;
    show.help = "of pvs: the view cell in which the culling eye lies";
    show.title = CULLSCOPE_TR("View cell");
    show.action = CULLSCOPE_TR("View &cell");
    show.explanation = CULLSCOPE_TR("Show in the active view the cell from anywhere in which the drawn objects may be seen");
    show.meanings = {{CULLSCOPE_TR("view cell of the culling eye"), contrastTo}};
    show.absent = noCell;
    return show;
}

Show pvsListing() {
    return listingShow({{CULLSCOPE_TR("find the view cell of the eye"), 0},
                        {CULLSCOPE_TR("none: each object is in the set"), 1},
                        {CULLSCOPE_TR("for each object"), 0},
                        {CULLSCOPE_TR("not in the cell's set: leave it out"), 1},
                        {CULLSCOPE_TR("test it against the frustum"), 1},
                        {CULLSCOPE_TR("outside: leave it out"), 1},
                        {CULLSCOPE_TR("draw the others, nearest first"), 0}});
}

ParameterDeclaration countParameter(const char* key, int64_t byDefault, double least, double most, const char* description) {
    return readWhenBuilding({key, ParameterType::Integer, byDefault, least, most, "", description, {}});
}

}  // namespace

RegisteredStrategy pvs() {
    StrategyInfo info{
        "pvs",
        CULLSCOPE_TR("Potentially visible sets"),
        CULLSCOPE_TR("Draws what may be seen from anywhere in the eye's cell, worked out beforehand for all cells."),
        "Wonka et al. 2006; Airey, Rohlf & Brooks 1990",
        {facingParameter(),
         readWhenBuilding(choiceParameter(kSets, kSampled, CULLSCOPE_TR("Where the cells' sets come from."),
                                          {{kSampled, CULLSCOPE_TR("what rays from the cell meet")},
                                           {kConservative, CULLSCOPE_TR("all but what is proven to be hidden from the cell")},
                                           {kGiven, CULLSCOPE_TR("the sets that came with the scene's file")}})),
         countParameter(kCells, 8, 1, 256, CULLSCOPE_TR("How many cells lie along the longest side of the scene.")),
         countParameter(kHalvings, 1, 0, 18, CULLSCOPE_TR("How many more times a cell is halved that a surface crosses.")),
         bySize(countParameter(kRays, 5000, 0, 1e9, CULLSCOPE_TR("How many rays look around from a cell.")), 10),
         readWhenBuilding(booleanParameter(kNeighbours, true,
                                           CULLSCOPE_TR("Whether a cell's sampled set also has what the cells beside it see."))),
         countParameter(kSeed, 1, 0, 1e9, CULLSCOPE_TR("What the rays' random numbers begin with."))}};
    info.needsEyePoint = true;
    info.sweeps = {{kRays, {"50", "500", "5000", "50000"}}};
    info.shows = {viewCellShow(), treeShow(), pvsListing(), barsShow("set-objects", CULLSCOPE_TR("What the cell's set has"))};
    return {std::move(info), std::make_shared<Pvs>()};
}

}  // namespace cullscope::occlusion
