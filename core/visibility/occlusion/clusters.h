#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `clusters`: meshes cut into clusters of neighbouring triangles (meshlets), which are tested against the frustum and, where
/// only front faces are drawn, by the cone of their normals, from a hierarchy's large groups to single clusters
/// (docs/methods/occlusion.md). Conservative on every mesh: bounds are verified after building, and a cone that does not hold is
/// not used.
[[nodiscard]] RegisteredStrategy clusters();

}  // namespace cullscope::occlusion
