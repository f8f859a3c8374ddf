#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// One unit normal for each position: the sum of the normals of its triangles, weighted by their area. A position without a
/// usable sum (no triangle, or normals that cancel) gets (0, 0, 1). The result does not depend on the number of processors.
[[nodiscard]] std::vector<Vec3f> areaWeightedNormals(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                                     const Progress& progress = {});

}  // namespace cullscope
