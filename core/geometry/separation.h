#pragma once

#include <cstdint>

#include "core/geometry/oriented_box.h"

namespace cullscope {

// The exact refinement of plane tests: a convex object that no single plane has outside may lie apart from the frustum all the
// same; an axis along which the two do not overlap tells (Gottschalk, Lin & Manocha 1996; stability cases 1 and 2).
//
// Any axis a is a certificate, so no error in the choice of one can cull too much. Along it the object must lie beyond the
// frustum by (margin + r)·|a|, r = 64u·M = 2^-47·M, where u = 2^-53 and M is at least the object's farthest distance from the
// eye. r holds all rounding, for every field, aspect and near : far. In camera coordinates (right, up, forward):
//   · the object's interval along a is off by less than 12u·M·|a|: 3u for each coordinate of its centre and its half edges
//     (together √3 times that), 3u for each dot product with a, and the sums;
//   · only frustum points within M of the eye can meet the object, so the frustum is cut at depth D = min(far, M). At depth d its
//     points reach at most d·s along a, with s = a_f + tan_w·|a_r| + tan_h·|a_u|, which is off by 3u of its terms' sum T. Where
//     T <= 4|a|, s·d is off by 12u·M·|a| for that, 4u for the product and 12u for D. Where T > 4|a|, |a_f| <= |a| leaves s > T/2,
//     so s·D is off by 11u of itself; an object beyond it has s·D <= M·|a|, hence 11u·M·|a|.
// The functions add r themselves: at margin 0, too, they part nothing that touches. conservativeMargin(M) = 2^27·r, besides,
// holds what the picture's floats misplace.

/// True: a box that no single plane has outside (classify) lies apart from the frustum by more than `margin` all the same. Axes:
/// the box's faces and the crosses of its edges with the frustum's; together with the planes they decide every pair of a box and
/// a frustum that lie apart by a little more than the margin.
[[nodiscard]] bool separated(const Frustum& frustum, const EyeBox& box, double margin);

/// The same for a turned or sheared box.
[[nodiscard]] bool separated(const Frustum& frustum, const OrientedBox& box, double margin);

/// The same for a sphere, relative to the eye; decides alone, without the planes. Axes: from the frustum's nearest point to the
/// centre, that one at a right angle to the edge between the sides next to the centre, and the normals of those two sides.
[[nodiscard]] bool separated(const Frustum& frustum, const Sphere& eyeSphere, double margin);

/// Whether a convex bound that no plane has outside can lie apart from the frustum at all; `planes` has bit p set where
/// FrustumPlane p may cut that bound. It takes planes of two of the pairs left/right, bottom/top, near/far: a bound inside all
/// planes but those of one pair, with a point on the inner side of each, has a point on the inner side of both.
[[nodiscard]] constexpr bool mayBeSeparated(uint32_t planes) {
    const uint32_t pairs = (planes | planes >> 1) & 0b010101;
    return (pairs & (pairs - 1)) != 0;
}

/// Whether a point of the box, grown by `margin` on each of its sides, lies on the frustum's near rectangle. Never false if one
/// does; true by mistake only within the rounding.
[[nodiscard]] bool meetsNearRectangle(const Frustum& frustum, const EyeBox& box, double margin);

}  // namespace cullscope
