#pragma once

#include "core/mesh/primitive/primitive.h"

namespace cullscope::primitive {

/// The occupancy value (体素占屏值) of a primitive: half the largest distance between two of its points, in its unit. Divided by
/// the distance it bounds k·tan θ, half the length of its projection (Du et al. 2017, Definition 1 and equation 4). The paper's
/// Table 1, which names a dimension for each kind, did not survive; these are our rules:
///  - sphere, disc, ring: the (outer) radius;
///  - cylinder, hollow cylinder, prism, box, wedge: half the diagonal;
///  - cone, pyramid, frustum of a pyramid: half the longest line between their corners or rims;
///  - eccentric cone, mitred cylinder: the same with both ends' slants added to the height: not above 1.5 of it;
///  - torus of half a turn or more: the outer radius, with half the height of a rectangular one as the other leg; of less: half
///  the
///    chord between its ends in place of the radius, for a circular one with the tube's radius as the other leg;
///  - dishes and heads: the radius where they are flatter than half a sphere, else half the longest line within.
[[nodiscard]] double occupancy(const Primitive& primitive);

}  // namespace cullscope::primitive
