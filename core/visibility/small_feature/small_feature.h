#pragma once

#include "core/visibility/registry.h"

namespace cullscope::small_feature {

/// `small-feature`: small-feature culling by two octrees (Du et al. 2017, Algorithms 1 to 4). The components with the largest
/// occupancy values, the plant's outline, are in octree L and culled by the frustum alone; the others are in octree S, of which
/// a leaf is left out where its largest value is too small for its distance. Approximate.
[[nodiscard]] RegisteredStrategy smallFeature();

}  // namespace cullscope::small_feature
