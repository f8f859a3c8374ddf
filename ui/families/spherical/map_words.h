#pragma once

#include <QString>

#include "ui/families/spherical/map_cells.h"
#include "ui/families/spherical/map_symbols.h"

namespace cullscope::ui {

/// The texts of the map's picture.

[[nodiscard]] QString colouringWords(spherical::MapColouring colouring);
/// The meaning of the scale's colours, with the unit.
[[nodiscard]] QString scaleWords(spherical::MapColouring colouring);
/// The object's name and its position relative to the frustum, in one line.
[[nodiscard]] QString objectWords(const ShownMap& shown);
/// The resulting decision: the case, the bands, or why directions decide nothing.
[[nodiscard]] QString decisionWords(const ShownMap& shown);
/// For a map with a quadtree: one line with the tests that were used and the number of triangles that each culled, then the use
/// of the kernel, or why there is none. Empty: the quadtree was not walked.
[[nodiscard]] QStringList walkWords(const ShownMap& shown);
/// Row, column, angles, entries, triangles, R and state of a cell, in several lines.
[[nodiscard]] QString cellWords(const ShownMap& shown, const TriangleStates* truth, const SphericalGrid::Cell& cell);
/// The result of the corner ray with that index.
[[nodiscard]] QString cornerWords(const spherical::SphericalDecision& decision, size_t corner);
/// The meaning of a cell's colour in a map coloured by state. Without truth a drawn cell is called "drawn", not "visible".
[[nodiscard]] QString stateWords(TriangleState state, bool truthKnown);
/// The meaning of a symbol over the map.
[[nodiscard]] QString symbolWords(MapSymbol symbol);
/// The meaning of the contours, which are drawn every `step` of α (radians).
[[nodiscard]] QString contourWords(double step);
/// The meaning of the edges of a sector, counted from 0.
[[nodiscard]] QString sectorWords(uint32_t sector);

}  // namespace cullscope::ui
