#pragma once

#include <vector>

#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// The cell of the quadtree at which the walk ended that holds a direction. Null: no triangle's centroid lies there, the object
/// was not walked, or the cull was not traced.
[[nodiscard]] const spherical::JudgedCell* judgedCellAt(const spherical::MapSnapshot& map, const Vec3& direction);

/// The border of a quadtree's cell as a closed line through points (θ, φ), radians, φ continued over the seam: the last one is
/// the first. The cell at level 0, which is the whole map, has none.
[[nodiscard]] std::vector<Vec2> cellOutline(MapLayout layout, const MapCell& cell);

/// The same of the cells at which the walk ended, of those that reach at least `leastSize` (radians) in both θ and φ.
[[nodiscard]] std::vector<std::vector<Vec2>> cellOutlines(const spherical::MapSnapshot& map, double leastSize);

/// The kernel's outline as the eye sees it, as a closed line like a contour: φ continued over the seam, the last point is the
/// first, a whole turn on where the line goes around a pole. Empty: the horizon was not used.
[[nodiscard]] std::vector<Vec2> horizonLine(const spherical::MapSnapshot& map);

}  // namespace cullscope
