#pragma once

#include <string_view>
#include <vector>

#include "core/frame/cell_map.h"
#include "core/gpu/renderer.h"

namespace cullscope {

/// The colour of a share from 0 to 1: a small share is near the background's lightness, a large one far from it.
[[nodiscard]] Vec3f rampColour(double share, const Vec3f& background);

/// By cell number; the background's colour where a cell is empty. States have the verdicts' colours.
[[nodiscard]] std::vector<Vec3f> cellColours(const CellMap& map, std::string_view colouring, const Vec3f& background);

/// A map of directions as a picture of a given size, φ to the right (0 … 360°) and θ downward (0 … 180°), twice as wide as it is
/// high, with ticks every 30°. It shows the cells' colours; the strategy's own cells, if they are some pixels large; boxes;
/// curves, a region's in dashed red with its inside shaded and a horizon's in wide red; the circles about an axis with its start
/// (dot) and end (ring); walked cells; and marks (crosses for those that missed). RGBA, rows from the bottom.
[[nodiscard]] std::vector<uint8_t> cellMapPicture(const CellMap& map, std::string_view colouring, const Viewport& size,
                                                  const DrawStyle& style);

}  // namespace cullscope
