#pragma once

#include <array>

#include "core/geometry/angle.h"
#include "core/geometry/bounds.h"
#include "core/geometry/plane.h"

namespace cullscope {

enum class Containment { Outside, Straddles, Inside };

/// The order of a frustum's planes; also the number under which a trace names the plane that culled.
enum class FrustumPlane { Left, Right, Bottom, Top, Near, Far };

/// A view frustum in coordinates relative to the eye (world axes, origin at the eye), so that nothing is lost far from
/// the world's origin: the four side planes pass through 0.
struct Frustum {
    std::array<Plane, 6> planes;  ///< unit normals pointing inward, in the order of FrustumPlane
    Vec3 forward{0.0, 0.0, -1.0};
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    double tanHalfWidth = 1.0;   ///< half the width of the view at distance 1
    double tanHalfHeight = 1.0;  ///< half the height of the view at distance 1
    double nearDistance = 0.1;
    double farDistance = 10.0;

    /// The corners relative to the eye: near bottom-left, bottom-right, top-right, top-left, then the same far.
    [[nodiscard]] std::array<Vec3, 8> corners() const;
};

/// Builds the planes from an orthonormal basis; exact to a few ulp for any near : far ratio, because no row of a
/// projection matrix is subtracted from another.
[[nodiscard]] Frustum makeFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double tanHalfWidth, double tanHalfHeight,
                                  double nearDistance, double farDistance);

/// How far a plane test must lean outward at `magnitude` (|coordinates| + size, eye-relative) to be conservative against
/// both its own rounding in double and the picture's: the GPU computes clip coordinates in float (24 bits) and snaps to
/// 1/256 pixel, and a rasterised sample lies at least half a pixel inside a side plane, so side planes need only the
/// rounding; near and far clip in float and need 2^-20 of the magnitude. Both get 2^-20: a millionth of the distance.
[[nodiscard]] constexpr double conservativeSlack(double magnitude) { return magnitude * 0x1p-20; }

}  // namespace cullscope
