#include "ui/families/spherical/map_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/visibility/spherical/judged_cells.h"
#include "ui/text/terms.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

class MapWords {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::MapWords)
};

QString caseWords(int caseNumber) {
    if (caseNumber == 1) return MapWords::tr("Case 1: all azimuths, one range in all");
    if (caseNumber == 2) return MapWords::tr("Case 2: one clump, one range a row");
    return MapWords::tr("Case 3: split by the seam, two ranges a row");
}

QString cornerName(size_t corner) {
    const std::array names{MapWords::tr("bottom left"), MapWords::tr("bottom right"), MapWords::tr("top right"),
                           MapWords::tr("top left")};
    return names[corner];
}

/// A range of angles, given in radians and written in degrees.
QString rangeWords(double from, double to) {
    return MapWords::tr("%1 to %2", "a range of numbers").arg(degreesText(from), degreesText(to));
}

QString countOrUnused(bool used, uint64_t count) { return used ? countText(count) : MapWords::tr("not used", "a test"); }

QString kernelWords(const spherical::MapSnapshot& map) {
    if (!map.kernel) return MapWords::tr("No kernel: the horizon is switched off, or the mesh is too small for one");
    if (!map.kernel->filled()) return MapWords::tr("No kernel: %1").arg(translated(InnerKernel::stateName(map.kernel->state())));
    if (map.decision.walk->horizon)
        return MapWords::tr("Kernel filled to R %1 at least").arg(lengthText(map.kernel->leastRadius()));
    if (map.decision.relation == spherical::SphereRelation::AroundEye)
        return MapWords::tr("Horizon not used: the eye is inside the bounding sphere");
    return MapWords::tr("Horizon not used: at the near plane, or too far away");
}

/// The decision on the quadtree cell in a direction; empty: there is none.
QString judgedWords(const spherical::MapSnapshot& map, const Vec3& direction) {
    const spherical::JudgedCell* judged = judgedCellAt(map, direction);
    if (!judged) return {};
    const CellTree::Node& node = map.tree->nodes()[judged->node];
    const QString verdict = judged->cause ? translated(causeName(*judged->cause)) : MapWords::tr("drawn");
    return MapWords::tr("Quadtree: level %1, triangles: %2, %3", "level of a cell, how many it has, what became of it")
        .arg(QString::number(node.level), countText(node.count), verdict);
}

Vec3 middleOf(const SphericalGrid& grid, const SphericalGrid::Cell& cell) {
    const double theta = (grid.thetaOf(cell.row) + grid.thetaOf(cell.row + 1)) / 2;
    const double phi = (grid.phiOf(cell.column) + grid.phiOf(cell.column + 1)) / 2;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// The state of the triangles that the cell owns, or a text that it owns none.
QString stateOfCell(const ShownMap& shown, const TriangleStates* truth, uint32_t cell) {
    const uint8_t tone = stateTone(shown, truth, cell);
    for (size_t state = 0; tone > 0 && state < kTriangleStateCount; ++state)
        if (CellTones::toneOf(TriangleState(state)) == tone) return stateWords(TriangleState(state), truth != nullptr);
    return MapWords::tr("owns no triangle");
}

}  // namespace

QString colouringWords(spherical::MapColouring colouring) {
    switch (colouring) {
        case spherical::MapColouring::Entries:
            return MapWords::tr("Entries a cell");
        case spherical::MapColouring::Radius:
            return MapWords::tr("Farthest R");
        case spherical::MapColouring::Level:
            return MapWords::tr("Level", "of a quadtree");
        case spherical::MapColouring::Kernel:
            return MapWords::tr("Kernel");
        default:
            return MapWords::tr("State");
    }
}

QString scaleWords(spherical::MapColouring colouring) {
    if (colouring == spherical::MapColouring::Radius) return MapWords::tr("farthest R, mesh units");
    if (colouring == spherical::MapColouring::Level) return MapWords::tr("level where the walk ended");
    if (colouring == spherical::MapColouring::Kernel) return MapWords::tr("R of the kernel, of the sphere's");
    return MapWords::tr("triangles a cell, logarithmic");
}

QString objectWords(const ShownMap& shown) {
    const QString relation = translated(spherical::relationName(shown.decision().relation));
    const size_t objects = shown.scene->instances().size();
    if (objects < 2) return MapWords::tr("%1: %2", "object, how it lies to the frustum").arg(shown.name(), relation);
    return MapWords::tr("%1 (%2 of %3): %4", "object, its number, how many there are, how it lies to the frustum")
        .arg(shown.name(), countText(shown.decision().instance + 1), countText(objects), relation);
}

QString decisionWords(const ShownMap& shown) {
    const spherical::SphericalDecision& decision = shown.decision();
    if (decision.relation == spherical::SphereRelation::Outside) return MapWords::tr("Nothing of it is drawn.");
    if (decision.region) return caseWords(decision.region->caseNumber);
    const QString drawn = countText(decision.drawnTriangles), all = countText(shown.map().maps.mesh().triangleCount());
    if (decision.bands)
        return MapWords::tr("Bands of %1; drawn: %2 of %3 triangles").arg(degreesText(decision.bands->width), drawn, all);
    if (decision.relation == spherical::SphereRelation::AroundEye && !decision.walk)
        return MapWords::tr("Everything of it is drawn.");
    return MapWords::tr("Drawn: %1 of %2 triangles").arg(drawn, all);
}

QStringList walkWords(const ShownMap& shown) {
    const std::optional<spherical::CellWalk>& walk = shown.decision().walk;
    if (!walk) return {};
    const auto culled = [&](Cause cause) { return walk->culled[size_t(cause)]; };
    return {MapWords::tr("Culled: frustum %1 · cones %2 · horizon %3", "by which test, triangles")
                .arg(countText(culled(Cause::OutsideFrustum)), countOrUnused(walk->cones, culled(Cause::BackFacing)),
                     countOrUnused(walk->horizon, culled(Cause::Hidden))),
            kernelWords(shown.map())};
}

QString cellWords(const ShownMap& shown, const TriangleStates* truth, const SphericalGrid::Cell& cell) {
    const SphericalGrid& grid = shown.grid();
    const SphericalMaps& maps = shown.maps();
    const uint32_t number = grid.number(cell);
    const SphericalMaps::Extent& extent = maps.extent(number);
    QStringList lines{MapWords::tr("Row %1, column %2").arg(cell.row).arg(cell.column),
                      MapWords::tr("θ %1, φ %2", "two ranges of angles")
                          .arg(rangeWords(grid.thetaOf(cell.row), grid.thetaOf(cell.row + 1)),
                               rangeWords(grid.phiOf(cell.column), grid.phiOf(cell.column + 1))),
                      MapWords::tr("Triangles in it: %1, of which it owns %2")
                          .arg(countText(maps.triangles(number).size()), countText(maps.centroids(number).size()))};
    if (!extent.empty())
        lines << MapWords::tr("R %1 to %2 mesh units").arg(lengthText(extent.nearest), lengthText(extent.farthest));
    if (const QString judged = judgedWords(shown.map(), middleOf(grid, cell)); !judged.isEmpty()) lines << judged;
    lines << stateOfCell(shown, truth, number);
    return lines.join(QLatin1Char('\n'));
}

QString cornerWords(const spherical::SphericalDecision& decision, size_t corner) {
    const spherical::CornerRay& ray = decision.rays[corner];
    const QString name = cornerName(corner);
    if (ray.hit)
        return MapWords::tr("Corner ray %1, %2: confirmed on triangle %3.")
            .arg(QString::number(corner + 1), name, countText(ray.hit->triangle));
    if (ray.span)
        return MapWords::tr("Corner ray %1, %2: passes the object by; its place is where it enters the sphere.")
            .arg(QString::number(corner + 1), name);
    return MapWords::tr("Corner ray %1, %2: misses the sphere; its place is the sphere's nearest point.")
        .arg(QString::number(corner + 1), name);
}

QString stateWords(TriangleState state, bool truthKnown) {
    if (state == TriangleState::Visible && !truthKnown) return MapWords::tr("drawn");
    return translated(triangleStateName(state));
}

QString symbolWords(MapSymbol symbol) {
    switch (symbol) {
        case MapSymbol::Region:
            return MapWords::tr("visible region");
        case MapSymbol::Box:
            return MapWords::tr("its box");
        case MapSymbol::CornerHit:
            return MapWords::tr("corner: hit");
        case MapSymbol::CornerMiss:
            return MapWords::tr("corner: miss, nearest point");
        case MapSymbol::Walked:
            return MapWords::tr("walked cells");
        case MapSymbol::RightAngle:
            return QStringLiteral("α = 90°");
        case MapSymbol::Start:
            return MapWords::tr("nearest to the eye");
        case MapSymbol::End:
            return MapWords::tr("opposite");
        case MapSymbol::JudgedCell:
            return MapWords::tr("cell of the quadtree");
        case MapSymbol::Horizon:
            return MapWords::tr("horizon of the kernel");
        default:
            return MapWords::tr("picked");
    }
}

QString contourWords(double step) { return MapWords::tr("contours of α every %1").arg(degreesText(step)); }

QString sectorWords(uint32_t sector) { return MapWords::tr("sector %1").arg(sector + 1); }

}  // namespace cullscope::ui
