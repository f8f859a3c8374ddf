#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// Largest polygon that is cut along its ears; a larger one that is not convex is cut as a fan (ear clipping takes n² steps).
inline constexpr size_t kLargestEarClipped = 20'000;

/// Twice the vector area of a closed polygon (Newell): its direction is the polygon's normal.
[[nodiscard]] Vec3 doubledArea(std::span<const Vec3> points);

/// Cuts a polygon of n >= 3 corners, convex or not, into n - 2 triangles that keep its direction; appends 3 (n - 2) numbers
/// in [0, n). Ear clipping (Meisters 1975) in the plane of the polygon's normal; a polygon that crosses itself is covered
/// somehow. Returns false where a polygon above kLargestEarClipped was cut as a fan without being convex.
bool triangulatePolygon(std::span<const Vec3> points, std::vector<uint32_t>& triangles, const Progress& progress);

}  // namespace cullscope
