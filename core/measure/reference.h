#pragma once

#include <cstdint>
#include <functional>
#include <memory>
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

/// Truths that are kept as long as they are asked for: each is drawn once for all who share scene, camera, size and facing rule.
class References {
public:
    [[nodiscard]] std::shared_ptr<const Reference> of(Renderer& renderer, const SceneBuffers& buffers, const View& view,
                                                      Facing facing);
    /// Drops those for whose scene and view `used` is false.
    void keep(const std::function<bool(const ScenePointer& scene, const Camera& camera, const Viewport& size)>& used);
    void clear() { m_known.clear(); }
    /// How many were drawn so far. For tests: truth is never computed twice.
    [[nodiscard]] size_t drawn() const { return m_drawn; }

private:
    struct Known {
        ScenePointer scene;
        Camera camera;
        std::shared_ptr<const Reference> truth;
    };
    std::vector<Known> m_known;
    size_t m_drawn = 0;
};

}  // namespace cullscope
