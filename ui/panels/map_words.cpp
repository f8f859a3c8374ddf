#include "ui/panels/map_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// From the highest to the lowest, in degrees.
QString rangeWords(double from, double to) {
    return MapWords::tr("%1 to %2", "a range of numbers").arg(degreesText(from), degreesText(to));
}

/// Of the triangles that the cell owns; none: it owns none.
QString stateOfCell(const ShownMap& shown, const TriangleStates* truth, uint32_t cell) {
    const uint8_t tone = stateTone(shown, truth, cell);
    for (size_t state = 0; tone > 0 && state < kTriangleStateCount; ++state)
        if (CellTones::toneOf(TriangleState(state)) == tone) return stateWords(TriangleState(state), truth != nullptr);
    return MapWords::tr("owns no triangle");
}

}  // namespace

QString colouringWords(MapColouring colouring) {
    if (colouring == MapColouring::Entries) return MapWords::tr("Entries a cell");
    return colouring == MapColouring::Radius ? MapWords::tr("Farthest R") : MapWords::tr("State");
}

QString scaleWords(MapColouring colouring) {
    if (colouring == MapColouring::Radius) return MapWords::tr("farthest R, mesh units");
    return MapWords::tr("triangles a cell, logarithmic");
}

QString objectWords(const ShownMap& shown) {
    const QString relation = translated(relationName(shown.decision().relation));
    const size_t objects = shown.scene->instances().size();
    if (objects < 2) return MapWords::tr("%1: %2", "object, how it lies to the frustum").arg(shown.name(), relation);
    return MapWords::tr("%1 (%2 of %3): %4", "object, its number, how many there are, how it lies to the frustum")
        .arg(shown.name(), countText(shown.decision().instance + 1), countText(objects), relation);
}

QString decisionWords(const ShownMap& shown) {
    const SphericalDecision& decision = shown.decision();
    if (decision.relation == SphereRelation::Outside) return MapWords::tr("Nothing of it is drawn.");
    if (decision.region) return caseWords(decision.region->caseNumber);
    const QString drawn = countText(decision.drawnTriangles), all = countText(shown.maps().mesh().triangleCount());
    if (decision.bands)
        return MapWords::tr("Bands of %1; drawn: %2 of %3 triangles").arg(degreesText(decision.bands->width), drawn, all);
    if (decision.relation == SphereRelation::AroundEye) return MapWords::tr("Everything of it is drawn.");
    return MapWords::tr("Drawn: %1 of %2 triangles").arg(drawn, all);
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
    lines << stateOfCell(shown, truth, number);
    return lines.join(QLatin1Char('\n'));
}

QString cornerWords(const SphericalDecision& decision, size_t corner) {
    const CornerRay& ray = decision.rays[corner];
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
        default:
            return MapWords::tr("picked");
    }
}

QString contourWords(double step) { return MapWords::tr("contours of α every %1").arg(degreesText(step)); }

QString sectorWords(uint32_t sector) { return MapWords::tr("sector %1").arg(sector + 1); }

QString absenceWords(MapAbsence absence) {
    switch (absence) {
        case MapAbsence::NoScene:
            return MapWords::tr("Open a scene to see what a strategy decides about it.");
        case MapAbsence::Preparing:
            return MapWords::tr("The strategy is being prepared…");
        case MapAbsence::NotBuilt:
            return MapWords::tr("The strategy could not be built. Choose another one, or other parameters.");
        default:
            return {};
    }
}

QString lengthText(double length) { return QLocale().toString(length, 'g', 3); }

QString degreesText(double radians) {
    const double degrees = radians * 180.0 / std::numbers::pi;
    // No more digits than are not zero, and no error of rounding.
    const double rounded = std::round(degrees * 100.0) / 100.0;
    return QLocale().toString(rounded, 'g', 5) + QStringLiteral("°");
}

}  // namespace cullscope::ui
