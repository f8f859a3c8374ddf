#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::spherical {

/// `spherical-lossless`: the map of directions without the errors of its walks (methods.md). A hierarchy over the objects and a
/// quadtree over each one's map against the frustum; normal cones where only front sides are drawn; the horizon of the inner
/// kernel where the mesh is closed and the eye outside. Conservative on every mesh: what does not hold for one is left out.
[[nodiscard]] StrategyInfo sphericalLosslessInfo();
[[nodiscard]] StrategyPointer makeSphericalLossless(ParameterSet parameters);

}  // namespace cullscope::spherical
