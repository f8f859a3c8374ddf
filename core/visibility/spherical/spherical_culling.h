#pragma once

#include "core/visibility/registry.h"

namespace cullscope::spherical {

/// `spherical`: Han & Hong 2008 as published (Appendix 1), for every instance of a scene, with one set of maps for each mesh.
/// Approximate. Where the frustum cuts an object's bounding sphere, it draws the box of cells between the four corner rays' hits.
/// Where the sphere lies inside the frustum, it uses contour bands and the S test. Where the eye is inside the sphere, it draws
/// the whole object.
[[nodiscard]] RegisteredStrategy spherical();

}  // namespace cullscope::spherical
