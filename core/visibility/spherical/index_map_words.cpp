#include "core/visibility/spherical/index_map_words.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/message.h"
#include "core/visibility/spherical/judged_cells.h"

namespace cullscope::spherical {
namespace {

Words caseWords(int caseNumber) {
    if (caseNumber == 1) return {CULLSCOPE_TR("Case 1: all azimuths, one range in all")};
    if (caseNumber == 2) return {CULLSCOPE_TR("Case 2: one clump, one range a row")};
    return {CULLSCOPE_TR("Case 3: split by the seam, two ranges a row")};
}

constexpr std::array kCornerNames{CULLSCOPE_TR("bottom left"), CULLSCOPE_TR("bottom right"), CULLSCOPE_TR("top right"),
                                  CULLSCOPE_TR("top left")};

Term countOrUnused(bool used, uint64_t count) { return used ? Term::count(count) : Term::marked(CULLSCOPE_TR("not used")); }

Words kernelWords(const MapSnapshot& map) {
    if (!map.kernel) return {CULLSCOPE_TR("No kernel: the horizon is switched off, or the mesh is too small for one")};
    if (!map.kernel->filled())
        return {CULLSCOPE_TR("No kernel: %1"), {Term::marked(InnerKernel::stateName(map.kernel->state()))}};
    if (map.decision.walk->hiding)
        return {CULLSCOPE_TR("Kernel filled to R %1 at least"), {Term::length(map.kernel->leastRadius())}};
    if (map.decision.relation == SphereRelation::AroundEye)
        return {CULLSCOPE_TR("Horizon not used: the eye is inside the bounding sphere")};
    return {CULLSCOPE_TR("Horizon not used: at the near plane, too far away, or of few triangles")};
}

Vec3 middleOf(const SphericalGrid& grid, const SphericalGrid::Cell& cell) {
    const double theta = (grid.thetaOf(cell.row) + grid.thetaOf(cell.row + 1)) / 2;
    const double phi = (grid.phiOf(cell.column) + grid.phiOf(cell.column + 1)) / 2;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

}  // namespace

Words objectWords(const MapSnapshot& map, const std::string& object, size_t objects) {
    const Term relation = Term::marked(relationName(map.decision.relation));
    if (objects < 2) return {CULLSCOPE_TR("%1: %2"), {Term::name(object), relation}};
    return {CULLSCOPE_TR("%1 (%2 of %3): %4"),
            {Term::name(object), Term::count(map.decision.instance + 1), Term::count(objects), relation}};
}

Words decisionWords(const MapSnapshot& map) {
    const SphericalDecision& decision = map.decision;
    if (decision.relation == SphereRelation::Outside) return {CULLSCOPE_TR("Nothing of it is drawn.")};
    if (decision.region) return caseWords(decision.region->caseNumber);
    const Term drawn = Term::count(decision.drawnTriangles), all = Term::count(map.maps.mesh().triangleCount());
    if (decision.bands)
        return {CULLSCOPE_TR("Bands of %1; drawn: %2 of %3 triangles"), {Term::angle(decision.bands->width), drawn, all}};
    if (decision.relation == SphereRelation::AroundEye && !decision.walk) return {CULLSCOPE_TR("Everything of it is drawn.")};
    return {CULLSCOPE_TR("Drawn: %1 of %2 triangles"), {drawn, all}};
}

std::vector<Words> walkWords(const MapSnapshot& map) {
    const std::optional<CellWalk>& walk = map.decision.walk;
    if (!walk) return {};
    const auto culled = [&](Cause cause) { return walk->culled[size_t(cause)]; };
    std::vector<Words> lines{{CULLSCOPE_TR("Culled: frustum %1 · cones %2 · horizon %3"),
                              {Term::count(culled(Cause::OutsideFrustum)), countOrUnused(walk->cones, culled(Cause::BackFacing)),
                               countOrUnused(walk->hiding, culled(Cause::Hidden))}}};
    if (map.decision.leftOutAlone > 0)
        lines.push_back({CULLSCOPE_TR("Of the drawn cells, left out one by one: %1"), {Term::count(map.decision.leftOutAlone)}});
    lines.push_back(kernelWords(map));
    return lines;
}

std::vector<Words> cellWords(const MapSnapshot& map, const SphericalGrid::Cell& cell) {
    const SphericalMaps& maps = *map.maps;
    const SphericalGrid& grid = maps.grid();
    const uint32_t number = grid.number(cell);
    const SphericalMaps::Extent extent = maps.extent(number);
    std::vector<Words> lines{{CULLSCOPE_TR("Row %1, column %2"), {Term::plain(cell.row), Term::plain(cell.column)}},
                             {CULLSCOPE_TR("θ %1 to %2, φ %3 to %4"),
                              {Term::angle(grid.thetaOf(cell.row)), Term::angle(grid.thetaOf(cell.row + 1)),
                               Term::angle(grid.phiOf(cell.column)), Term::angle(grid.phiOf(cell.column + 1))}},
                             {CULLSCOPE_TR("Triangles in it: %1, of which it owns %2"),
                              {Term::count(maps.triangles(number).size()), Term::count(maps.centroids(number).size())}}};
    if (!extent.empty())
        lines.push_back({CULLSCOPE_TR("R %1 to %2 mesh units"), {Term::length(extent.nearest), Term::length(extent.farthest)}});
    const JudgedCell* judged = judgedCellAt(map, middleOf(grid, cell));
    if (!judged) return lines;
    const CellTree::Node& node = map.tree->nodes()[judged->node];
    lines.push_back({CULLSCOPE_TR("Quadtree: level %1, triangles: %2, %3"),
                     {Term::plain(node.level), Term::count(node.count),
                      Term::marked(judged->cause ? causeName(*judged->cause) : CULLSCOPE_TR("drawn"))}});
    return lines;
}

Words cornerWords(const SphericalDecision& decision, size_t corner) {
    const CornerRay& ray = decision.rays[corner];
    const Term number = Term::plain(corner + 1), name = Term::marked(kCornerNames[corner]);
    if (ray.hit)
        return {CULLSCOPE_TR("Corner ray %1, %2: confirmed on triangle %3."), {number, name, Term::count(ray.hit->triangle)}};
    if (ray.span)
        return {CULLSCOPE_TR("Corner ray %1, %2: passes the object by; its place is where it enters the sphere."),
                {number, name}};
    return {CULLSCOPE_TR("Corner ray %1, %2: misses the sphere; its place is the sphere's nearest point."), {number, name}};
}

Words sectorWords(uint32_t sector) { return {CULLSCOPE_TR("sector %1"), {Term::plain(sector + 1)}}; }

double contourStep(double width) {
    constexpr double kLeastContourStep = 15.0;  // degrees
    const double degrees = width * 180.0 / std::numbers::pi;
    return width * std::max(1.0, std::ceil(kLeastContourStep / degrees - 1e-9));
}

std::vector<MapLegendEntry> regionLegend() {
    return {{MapSymbol::Region, {CULLSCOPE_TR("visible region")}},
            {MapSymbol::Box, {CULLSCOPE_TR("box of the region")}},
            {MapSymbol::Hit, {CULLSCOPE_TR("corner: hit")}},
            {MapSymbol::Miss, {CULLSCOPE_TR("corner: miss, nearest point")}},
            {MapSymbol::Walked, {CULLSCOPE_TR("cells along a ray")}}};
}

std::vector<MapLegendEntry> bandLegend(double step) {
    return {{MapSymbol::Circle, {CULLSCOPE_TR("contours of α every %1"), {Term::angle(step)}}},
            {MapSymbol::RightAngle, {"α = 90°"}},
            {MapSymbol::Start, {CULLSCOPE_TR("nearest to the eye")}},
            {MapSymbol::End, {CULLSCOPE_TR("opposite")}}};
}

std::vector<MapLegendEntry> walkLegend(bool horizon) {
    std::vector<MapLegendEntry> entries{{MapSymbol::Cell, {CULLSCOPE_TR("cell of the quadtree")}}};
    if (horizon) entries.push_back({MapSymbol::Horizon, {CULLSCOPE_TR("horizon of the kernel")}});
    return entries;
}

}  // namespace cullscope::spherical
