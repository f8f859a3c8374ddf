#pragma once

#include <cstdint>

#include "core/geometry/oriented_box.h"

namespace cullscope {

// The exact refinement of plane tests. A convex object may be separate from the frustum although it lies outside no single plane;
// an axis along which the two do not overlap proves that (Gottschalk, Lin & Manocha 1996; stability cases 1 and 2).
//
// Any axis a along which they do not overlap is a proof, so a rounding error in the choice of the axis can never cull too much.
// Along it the object must lie beyond the frustum by (margin + r)·|a|, r = 64u·M = 2^-47·M, where u = 2^-53 and M is at least the
// object's farthest distance from the eye. r bounds all rounding, for every field, aspect and near : far. In camera coordinates
// (right, up, forward):
//   · the object's interval along a has an error of less than 12u·M·|a|: 3u for each coordinate of its centre and its half edges
//     (together √3 times that), 3u for each dot product with a, and the sums;
//   · only frustum points within M of the eye can touch the object, so the frustum is cut at depth D = min(far, M). At depth d
//   its
//     points reach at most d·s along a, with s = a_f + tan_w·|a_r| + tan_h·|a_u|, which has an error of 3u of its terms' sum T.
//     Where T <= 4|a|, s·d has an error of 12u·M·|a| for that, 4u for the product and 12u for D. Where T > 4|a|, |a_f| <= |a|
//     leaves s > T/2, so s·D has a relative error of 11u; an object beyond it has s·D <= M·|a|, hence 11u·M·|a|.
// In a parallel view the frustum's half sizes are added to the interval as they are: their sum C = hw·|a_r| + hh·|a_u| has an
// error of 4u·C. An object beyond it has C <= M·|a|, hence 4u·M·|a|, and s = a_f is exact.
// The functions add r themselves: at margin 0, too, objects that touch are never reported as separate. conservativeMargin(M) =
// 2^27·r covers the float rounding of the picture besides.

/// Whether a box that lies outside no single plane (classify) is separate from the frustum by more than `margin`. The axes are
/// the box's face normals and the cross products of its edges with the frustum's; together with the planes they separate every
/// box and frustum that are apart by a little more than the margin. Never true where they touch.
[[nodiscard]] bool separated(const Frustum& frustum, const EyeBox& box, double margin);

/// The same for a turned or sheared box.
[[nodiscard]] bool separated(const Frustum& frustum, const OrientedBox& box, double margin);

/// The same for a sphere relative to the eye; needs no plane tests. The axes: from the frustum's nearest point to the centre, the
/// component of that perpendicular to the edge between the two sides next to the centre, and the normals of those two sides.
[[nodiscard]] bool separated(const Frustum& frustum, const Sphere& eyeSphere, double margin);

/// Whether a convex bound that lies outside no plane can be separate from the frustum at all; `planes` has bit p set where
/// FrustumPlane p may cut that bound. Planes of two of the pairs left/right, bottom/top, near/far must cut it: a bound that is
/// inside all planes but those of one pair, and has a point on the inner side of each of these two, also has one point on the
/// inner side of both.
[[nodiscard]] constexpr bool mayBeSeparated(uint32_t planes) {
    const uint32_t pairs = (planes | planes >> 1) & 0b010101;
    return (pairs & (pairs - 1)) != 0;
}

/// Whether a point of the box, grown by `margin` on each side, lies on the frustum's near rectangle. Never false where one does;
/// true where none does only within rounding, that of the depth (depthRoom) in a parallel view.
[[nodiscard]] bool meetsNearRectangle(const Frustum& frustum, const EyeBox& box, double margin);

}  // namespace cullscope
