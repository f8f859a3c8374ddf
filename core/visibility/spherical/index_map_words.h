#pragma once

#include "core/frame/cell_map.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The texts of the index map.

/// The object's name and its position relative to the frustum, in one line.
[[nodiscard]] Words objectWords(const MapSnapshot& map, const std::string& object, size_t objects);
/// The resulting decision: the case, the bands, or why directions decide nothing.
[[nodiscard]] Words decisionWords(const MapSnapshot& map);
/// For a map with a quadtree: one line with the tests that were used and the number of triangles that each culled, then the use
/// of the kernel, or why there is none. Empty: the quadtree was not walked.
[[nodiscard]] std::vector<Words> walkWords(const MapSnapshot& map);
/// Row, column, angles, entries, triangles, R and the quadtree's cell of a cell, in several lines.
[[nodiscard]] std::vector<Words> cellWords(const MapSnapshot& map, const SphericalGrid::Cell& cell);
/// The result of the corner ray with that index.
[[nodiscard]] Words cornerWords(const SphericalDecision& decision, size_t corner);
[[nodiscard]] Words sectorWords(uint32_t sector);

/// The angle between two contours of a small map in radians: a whole number of bands.
[[nodiscard]] double contourStep(double width);
/// What the symbols over a map mean: of a region; of bands whose contours are drawn at a step; of a walk.
[[nodiscard]] std::vector<MapLegendEntry> regionLegend();
[[nodiscard]] std::vector<MapLegendEntry> bandLegend(double step);
[[nodiscard]] std::vector<MapLegendEntry> walkLegend(bool horizon);

}  // namespace cullscope::spherical
