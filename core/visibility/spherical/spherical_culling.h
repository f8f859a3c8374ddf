#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::spherical {

/// `spherical`: Han & Hong 2008 as published (Appendix 1), for every instance of a scene with one set of maps a mesh.
/// Approximate. Where the frustum cuts an object's bounding sphere: the box of cells between the four corner rays' hits. Where
/// the sphere lies inside the frustum: contour bands and the S test. Where the eye is inside the sphere: all of the object.
[[nodiscard]] StrategyInfo sphericalInfo();
[[nodiscard]] StrategyPointer makeSpherical(ParameterSet parameters);

/// `spherical-horizon`: the exact slope in place of S. Conservative where every mesh is star-shaped around the centre of its
/// bounding sphere, approximate elsewhere. The corner rays are left out: where the frustum cuts a sphere, the slopes alone
/// decide.
[[nodiscard]] StrategyInfo sphericalHorizonInfo();
[[nodiscard]] StrategyPointer makeSphericalHorizon(ParameterSet parameters);

}  // namespace cullscope::spherical
