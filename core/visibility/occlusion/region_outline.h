#pragma once

#include <array>
#include <vector>

#include "core/scene/region_sets.h"

namespace cullscope::occlusion {

/// The edges of a region, which is convex, as far as it lies in a box; empty where it does not. Rounded: for display.
[[nodiscard]] std::vector<std::array<Vec3, 2>> regionOutline(const RegionSets& sets, uint32_t region, const Box3& box);

}  // namespace cullscope::occlusion
