#pragma once

#include <array>
#include <optional>

#include "core/geometry/angle.h"
#include "core/geometry/plane.h"

namespace cullscope {

/// The range of z/w that a projection gives to points between its near and its far plane.
enum class ClipDepth {
    MinusOneToOne,     ///< OpenGL's default
    ZeroToOne,         ///< Direct3D, Vulkan, Metal
    ReversedZeroToOne  ///< the same, with near at 1: used by View
};

/// In the order of FrustumPlane, unit normals pointing inward. Left is where x/w = −1 and bottom where y/w = −1: with a mirroring
/// matrix, or one whose y points downward, they lie on the opposite side of the picture.
using FrustumPlanes = std::array<Plane, 6>;

/// The frustum planes of a clip matrix, from its rows: inside is −w <= x <= w and so on, and each such inequality is a plane
/// (Gribb & Hartmann 2001). The planes are in the coordinates that `clip` takes to clip space; any handedness. Subtracting rows
/// loses digits by cancellation: with depths of −1 … 1 and 0 … 1 this affects the far plane (at near : far = 1e-6 : 1e9 its
/// distance is wrong by a thousandth and by an eighth, in double); with the reversed range no similar numbers are subtracted.
/// makeFrustum (geometry/frustum.h) is accurate for every range. None where the matrix is singular or not finite, or a plane lies
/// at infinity.
[[nodiscard]] std::optional<FrustumPlanes> planesFromRows(const Mat4& clip, ClipDepth depth);

/// The same from the corners of the clip cube, transformed by the inverse matrix: the method of Orangelie 2023 (papers/INDEX.md,
/// 004) with its errors corrected. There, left, right, bottom and top were all built from the same three near corners; the
/// corners were not divided by w; the normals were not of unit length, so that a distance could not be compared with a radius;
/// and the direction of a normal depended on the handedness. Here each plane has three corners of its own, and a point inside
/// decides the direction. None where the matrix is singular or not finite, or the corners do not all lie in front of the eye.
[[nodiscard]] std::optional<FrustumPlanes> planesFromCorners(const Mat4& clip, ClipDepth depth);

/// The difference of two sets of planes: the largest angle between normals and the largest difference of offsets.
struct PlaneDifference {
    Angle angle;
    double offset = 0.0;
};
[[nodiscard]] PlaneDifference largestDifference(const FrustumPlanes& a, const FrustumPlanes& b);

}  // namespace cullscope
