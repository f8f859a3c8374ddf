#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// One unit normal a position: the sum of its triangles' normals, each weighted by the triangle's area. A position without
/// a usable sum (no triangle, or triangles that cancel out) gets (0, 0, 1). The same result on any number of processors.
[[nodiscard]] std::vector<Vec3f> areaWeightedNormals(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                                     const Progress& progress = {});

}  // namespace cullscope
