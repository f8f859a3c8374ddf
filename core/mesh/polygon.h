#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// The largest polygon for ear clipping, which takes n² steps; a larger one that is not convex is cut as a fan.
inline constexpr size_t kLargestEarClipped = 20'000;

/// Twice the vector area of a closed polygon (Newell); it points along the polygon's normal.
[[nodiscard]] Vec3 doubledArea(std::span<const Vec3> points);

/// Cuts a polygon of n >= 3 corners, convex or not, into n - 2 triangles with the same orientation; appends 3 (n - 2) corner
/// indices in [0, n). Ear clipping (Meisters 1975) in the plane of the polygon's normal; a polygon that crosses itself also gets
/// n - 2 triangles, but what they cover is not specified. Returns false where a polygon above kLargestEarClipped was cut as a fan
/// without being convex.
bool triangulatePolygon(std::span<const Vec3> points, std::vector<uint32_t>& triangles, const Progress& progress);

}  // namespace cullscope
