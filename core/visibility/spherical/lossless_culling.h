#pragma once

#include "core/visibility/registry.h"

namespace cullscope::spherical {

/// `spherical-lossless`: culling by a map of directions without the errors of the published method (docs/methods/spherical.md).
/// It tests a hierarchy over the objects, and a quadtree over each object's map, against the frustum; uses normal cones where
/// only front faces are drawn; and uses the horizon of the inner kernel where the mesh is closed and the eye outside.
/// Conservative on every mesh: a test whose conditions a mesh does not meet is not used for it.
[[nodiscard]] RegisteredStrategy sphericalLossless();

}  // namespace cullscope::spherical
