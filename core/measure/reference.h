#pragma once

#include <cstdint>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/gpu/renderer.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// Ground truth: the triangles and pixels that are visible from a View under a facing rule. Rows count from the bottom.
struct Reference {
    Viewport size;
    Facing facing = Facing::TwoSided;
    std::vector<float> depth;                ///< reversed; 0: no triangle
    std::vector<uint32_t> triangle;          ///< scene triangle number + 1; 0: no triangle
    std::vector<uint32_t> visibleTriangles;  ///< scene triangle numbers, ascending, unique
    uint64_t coveredPixels = 0;

    /// The visible triangles as triangleStates needs them. Valid as long as this object lives.
    [[nodiscard]] VisibleTriangles visible() const { return {visibleTriangles, facing}; }
};

/// The item buffer reference (docs/measuring.md, "Ground truth").
/// Throws Error(Usage) for a scene of more than 2^32 − 2 triangles.
[[nodiscard]] Reference itemBufferReference(Renderer& renderer, const SceneBuffers& buffers, const View& view, Facing facing);

}  // namespace cullscope
