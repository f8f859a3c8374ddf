#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/camera.h"
#include "core/frame/draw_list.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What a ray through every pixel's centre meets first: the independent check of the item buffer. Rows count from the bottom.
struct RayReference {
    Viewport size;
    Facing facing = Facing::TwoSided;
    std::vector<uint32_t> triangle;     ///< scene triangle number + 1; 0: nothing there
    std::vector<double> depth;          ///< reversed, worked out in double from the triangle's plane; 0: nothing there
    std::vector<double> depthPerPixel;  ///< how much the depth of that triangle's plane changes over one pixel (|∂x| + |∂y|)
    uint64_t coveredPixels = 0;
};

/// Embree rays in robust mode (Woop et al. 2013). Shares no code with the GPU path: own projection of pixels, own facing rule.
/// Costs a BVH over the scene as seen from the eye (eye-relative floats): about 1 s and 150 bytes a triangle for a million.
/// Throws Error(Usage) for more than 2^32 − 2 triangles, Error(Interrupted) on stop.
[[nodiscard]] RayReference rayReference(const Scene& scene, const View& view, Facing facing, const Progress& progress = {});

}  // namespace cullscope
