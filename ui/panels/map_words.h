#pragma once

#include <QString>

#include "ui/panels/map_cells.h"
#include "ui/panels/map_symbols.h"

namespace cullscope::ui {

/// What the map's picture says in words.

[[nodiscard]] QString colouringWords(MapColouring colouring);
/// What the scale's colours mean, with the unit.
[[nodiscard]] QString scaleWords(MapColouring colouring);
/// Which object it is and how it lies to the frustum, one line.
[[nodiscard]] QString objectWords(const ShownMap& shown);
/// What follows from that: the case, the bands, or why nothing is decided by direction.
[[nodiscard]] QString decisionWords(const ShownMap& shown);
/// Of a map with a quadtree: which tests held and what each culled, one line; then what the kernel is good for, or why there is
/// none. Empty: nothing was walked.
[[nodiscard]] QStringList walkWords(const ShownMap& shown);
/// Row, column, angles, entries, triangles, R and state of a cell, several lines.
[[nodiscard]] QString cellWords(const ShownMap& shown, const TriangleStates* truth, const SphericalGrid::Cell& cell);
/// What the corner ray with that index found.
[[nodiscard]] QString cornerWords(const spherical::SphericalDecision& decision, size_t corner);
/// Of a cell's tone in a map coloured by state; without truth, what is drawn is only that.
[[nodiscard]] QString stateWords(TriangleState state, bool truthKnown);
/// Instead of a map; empty: the strategy has none.
[[nodiscard]] QString absenceWords(MapAbsence absence);
/// What a symbol over the map stands for.
[[nodiscard]] QString symbolWords(MapSymbol symbol);
/// The same of the contours, drawn at every so much of α (radians).
[[nodiscard]] QString contourWords(double step);
/// The same of a sector's edges, counted from 0.
[[nodiscard]] QString sectorWords(uint32_t sector);
/// A length in the mesh's units, three digits.
[[nodiscard]] QString lengthText(double length);
/// An angle in degrees, as many digits as tell the map's cells apart.
[[nodiscard]] QString degreesText(double radians);

}  // namespace cullscope::ui
