#pragma once

#include <array>

#include "core/geometry/types.h"

namespace cullscope {

using TriangleCorners = std::array<Vec3, 3>;

/// The least distance from the origin to a triangle's points; its corners may coincide.
[[nodiscard]] double nearestDistance(const TriangleCorners& corners);

/// The solid angle of a triangle from the origin, steradians, negative where it turns clockwise: van Oosterom & Strackee 1983.
[[nodiscard]] double solidAngle(const TriangleCorners& corners);

}  // namespace cullscope
