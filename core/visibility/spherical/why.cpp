#include "core/visibility/spherical/why.h"

#include <algorithm>
#include <cstdio>
#include <numbers>

#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/contour_bands.h"

namespace cullscope::spherical {
namespace {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

std::string degrees(double radians) { return number(radians * 180.0 / std::numbers::pi); }

WhyStep said(Message sentence, Containment containment = Containment::Straddles) {
    return {std::move(sentence), {}, {}, {}, containment};
}

Vec3 centroidOf(const SphericalMaps& maps, uint32_t triangle) {
    const auto [a, b, c] = maps.corners(triangle);
    return (a + b + c) / 3.0;
}

Message cellSentence(const SphericalGrid& grid, const SphericalGrid::Cell& cell) {
    return {CULLSCOPE_TR("Its centroid lies in the map's row %1, column %2: zenith angle %3° to %4°, azimuth %5° to %6°."),
            {std::to_string(cell.row), std::to_string(cell.column), degrees(grid.thetaOf(cell.row)),
             degrees(grid.thetaOf(cell.row + 1)), degrees(grid.phiOf(cell.column)), degrees(grid.phiOf(cell.column + 1))}};
}

WhyStep regionStep(const VisibleRegion& region, bool drawn) {
    const std::string number = std::to_string(region.caseNumber);
    if (drawn)
        return said({CULLSCOPE_TR("The cell lies in the visible region's boxes (case %1)."), {number}}, Containment::Inside);
    return said({CULLSCOPE_TR("The cell lies outside the visible region's boxes (case %1)."), {number}}, Containment::Outside);
}

/// What was said of the band sector in which the middle of a cell lies; none where nothing was, as in a log that is coarser.
const Decision* saidOfSector(const FrameLog& log, const SphericalDecision& object, const Vec3& middle) {
    const Subject sector{Subject::Kind::Band, sectorOfCell(*object.bands, middle), object.instance};
    const auto said = std::ranges::find(log.decisions, sector, &Decision::subject);
    return said == log.decisions.end() ? nullptr : &*said;
}

/// The node at which the walk ended for a place in the order; null where it is not known.
const JudgedCell* judgedAt(const CellTree& tree, const CellWalk& walk, uint32_t place) {
    const auto found = std::ranges::find_if(walk.judged, [&](const JudgedCell& judged) {
        const CellTree::Node& node = tree.nodes()[judged.node];
        return node.first <= place && place < node.first + node.count;
    });
    return found == walk.judged.end() ? nullptr : &*found;
}

Message judgedSentence(const JudgedCell& judged) {
    const std::optional<Cause>& cause = judged.cause;
    if (judged.bridged)
        return {
            CULLSCOPE_TR("A test left the cell out, but it is drawn with the ranges on both of its sides: so few triangles are "
                         "not worth a range of their own."),
            {}};
    if (!cause) return {CULLSCOPE_TR("No test left the cell out: its triangles are drawn."), {}};
    if (*cause == Cause::BackFacing)
        return {CULLSCOPE_TR("All normals of the cell lie in a cone that is turned away from the eye, by more than the picture's "
                             "snapping could undo."),
                {}};
    if (*cause == Cause::Hidden)
        return {CULLSCOPE_TR("All sight lines to the cell pass through the solid's inner kernel first."), {}};
    return {CULLSCOPE_TR("The box around the cell's triangles lies outside one plane of the frustum."), {}};
}

/// Why normal cones were not tested for the object's cells; none where they were.
std::optional<Message> conesLeftOut(const CellWalk& walk) {
    if (walk.cones) return std::nullopt;
    return Message{
        CULLSCOPE_TR("Normal cones are not used: both sides of the triangles are drawn, the test is switched off, or all of "
                     "the object is in view and too few of its cells could face away."),
        {}};
}

std::optional<Message> horizonLeftOut(const MapSnapshot& map) {
    if (map.decision.walk->hiding) return std::nullopt;
    if (map.kernel && !map.kernel->filled())
        return Message{CULLSCOPE_TR("The kernel's horizon is not used: %1."), {InnerKernel::stateName(map.kernel->state())}};
    return Message{
        CULLSCOPE_TR("The kernel's horizon is not used here: the near plane cuts the bounding sphere, the object is too "
                     "small in the picture, all of it is in view and it has few triangles, or the test is switched off."),
        {}};
}

void addWalkSteps(const MapSnapshot& map, uint32_t triangle, std::vector<WhyStep>& steps) {
    if (!map.tree->divided()) {
        Message small{CULLSCOPE_TR("The object has too few triangles to be divided: it is one cell."), {}};
        steps.push_back(said(std::move(small)));
        return;
    }
    for (const std::optional<Message>& reason : {conesLeftOut(*map.decision.walk), horizonLeftOut(map)})
        if (reason) steps.push_back(said(*reason));
    const std::span<const uint32_t> order = map.tree->triangleOrder();
    const auto place = uint32_t(std::ranges::find(order, triangle) - order.begin());
    const JudgedCell* judged = judgedAt(*map.tree, *map.decision.walk, place);
    if (judged == nullptr) return;
    const CellTree::Node& node = map.tree->nodes()[judged->node];
    steps.push_back(said({CULLSCOPE_TR("The walk over the map ended at a cell of level %1, which holds %2 triangles."),
                          {std::to_string(node.level), std::to_string(node.count)}}));
    steps.push_back(said(judgedSentence(*judged), judged->cause ? Containment::Outside : Containment::Inside));
}

}  // namespace

void addMapSteps(const MapSnapshot& map, const FrameLog& log, uint32_t triangle, std::vector<WhyStep>& steps) {
    const SphericalDecision& decision = map.decision;
    steps.push_back(said({CULLSCOPE_TR("The object's bounding sphere: %1."), {relationName(decision.relation)}}));
    if (decision.relation == SphereRelation::Outside) return;
    if (map.tree) {
        if (decision.walk) addWalkSteps(map, triangle, steps);
        return;
    }
    const SphericalGrid& grid = map.maps->grid();
    const SphericalGrid::Cell cell = grid.cellOf(centroidOf(*map.maps, triangle));
    const uint32_t number = grid.number(cell);
    steps.push_back(said(cellSentence(grid, cell)));
    const bool drawn = std::any_of(decision.drawn.begin(), decision.drawn.end(),
                                   [&](const CellRun& run) { return run.first <= number && number < run.last; });
    if (decision.region) steps.push_back(regionStep(*decision.region, drawn));
    // With slopes the cell has a test of its own, which why() reads; else its band's test decides.
    if (!decision.bands || decision.bands->slopes) return;
    if (const Decision* band = saidOfSector(log, decision, CellDirections(grid).middle(cell))) steps.push_back(whyStep(*band));
}

}  // namespace cullscope::spherical
