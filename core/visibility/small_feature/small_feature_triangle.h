#pragma once

#include "core/visibility/registry.h"

namespace cullscope::small_feature {

/// `small-feature-triangle`: the traditional small-feature culling that Du et al. 2017 compare with. Objects are culled by the
/// frustum in groups, as `frustum-octree` does; then every triangle whose half longest edge, divided by the distance of its
/// centroid, is below the threshold is left out. Approximate.
[[nodiscard]] RegisteredStrategy smallFeatureTriangle();

}  // namespace cullscope::small_feature
