#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/frame/draw_list.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The first triangle hit by a ray through the centre of every pixel: an independent check of the item buffer. Rows count from
/// the bottom.
struct RayReference {
    Viewport size;
    Facing facing = Facing::TwoSided;
    std::vector<uint32_t> triangle;     ///< scene triangle number + 1; 0: no triangle
    std::vector<double> depth;          ///< reversed, computed in double from the triangle's plane; 0: no triangle
    std::vector<double> depthPerPixel;  ///< upper bound on the change of that plane's depth over one pixel (|∂x| + |∂y|)
    uint64_t coveredPixels = 0;
};

/// Embree rays in robust mode (Woop et al. 2013). Shares no code with the GPU path: it has its own projection of pixels and its
/// own facing rule. Costs a BVH over the scene as seen from the eye (eye-relative floats): about 1 s and 150 bytes per triangle
/// for a million triangles. Throws Error(Usage) for more than 2^32 − 2 triangles, Error(Interrupted) on a stop request.
[[nodiscard]] RayReference rayReference(const Scene& scene, const View& view, Facing facing, const Progress& progress = {});

}  // namespace cullscope
