#pragma once

#include <cstdint>
#include <vector>

#include "core/frame/commands.h"
#include "core/raster/scene_triangles.h"

namespace cullscope {

/// Marks the triangles that a picture shows (kShown) among the fates of the scene's triangles. `parallel`, by rows, and `simd`
/// change nothing.
void markShown(const FinishedPicture& picture, std::vector<uint8_t>& fates, bool parallel = true,
               RasterSimd simd = availableRasterSimd().back());

}  // namespace cullscope
