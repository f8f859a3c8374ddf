#pragma once

#include <vector>

#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The tested cell of the quadtree that holds a direction. Null where no triangle's centroid lies in that direction's cell, where
/// the object's quadtree was not walked, or where the frame was not recorded.
[[nodiscard]] const JudgedCell* judgedCellAt(const MapSnapshot& map, const Vec3& direction);

/// The border of a quadtree's cell as a closed line through points (θ, φ) in radians, φ continued over the seam: the last point
/// equals the first. Empty for the cell at level 0, which is the whole map.
[[nodiscard]] std::vector<Vec2> cellOutline(MapLayout layout, const MapCell& cell);

/// The borders of the tested cells that extend at least `leastSize` (radians) in both θ and φ.
[[nodiscard]] std::vector<std::vector<Vec2>> cellOutlines(const MapSnapshot& map, double leastSize);

/// The kernel's outline as seen from the eye, as a closed line like a contour: φ continued over the seam; the last point is the
/// first, or differs from it by a whole turn where the line goes around a pole. Empty where the horizon was not used.
[[nodiscard]] std::vector<Vec2> horizonLine(const MapSnapshot& map);

}  // namespace cullscope::spherical
