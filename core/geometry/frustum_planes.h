#pragma once

#include <array>
#include <optional>

#include "core/geometry/angle.h"
#include "core/geometry/plane.h"

namespace cullscope {

/// Which range of z/w a projection gives to what lies between its near and its far plane.
enum class ClipDepth {
    MinusOneToOne,     ///< OpenGL's default
    ZeroToOne,         ///< Direct3D, Vulkan, Metal
    ReversedZeroToOne  ///< the same, with near at 1: what View uses
};

/// In the order of FrustumPlane, unit normals pointing inward. Left is where x/w = −1 and bottom where y/w = −1: of a mirroring
/// matrix, or one whose y points downward, they lie on the other side of the picture.
using FrustumPlanes = std::array<Plane, 6>;

/// The planes of a view from its rows: inside is −w <= x <= w and so on, and each such inequality is a plane (Gribb & Hartmann
/// 2001). Coordinates are those that `clip` takes to clip space; any handedness. What is lost: a row subtracted from another
/// cancels. Depths of −1 … 1 and 0 … 1 lose the far plane so (at near : far = 1e-6 : 1e9 its distance is
/// off by a thousandth and by an eighth, in double); the reversed range subtracts nothing that is alike. makeFrustum
/// (geometry/frustum.h) loses nothing in any range.
/// None: the matrix is singular or not finite, or a plane lies at infinity.
[[nodiscard]] std::optional<FrustumPlanes> planesFromRows(const Mat4& clip, ClipDepth depth);

/// The same from the corners of the clip cube, taken back by the inverse matrix: the way of Orangelie 2023 (papers/INDEX.md,
/// 004), mended. There, left, right, bottom and top were all built from the three corners of near; the corners lacked the
/// division by w; the normals lacked unit length, so that a distance could not be compared with a radius; and whether a normal
/// pointed outward hung on the handedness. Here each plane has three corners of its own, and a point inside tells which way is
/// inward. None: as above, or the corners do not all lie before the eye.
[[nodiscard]] std::optional<FrustumPlanes> planesFromCorners(const Mat4& clip, ClipDepth depth);

/// How far two sets of planes lie apart: the largest angle between normals and the largest difference of offsets.
struct PlaneDifference {
    Angle angle;
    double offset = 0.0;
};
[[nodiscard]] PlaneDifference largestDifference(const FrustumPlanes& a, const FrustumPlanes& b);

}  // namespace cullscope
