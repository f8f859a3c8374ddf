#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/raster/screen_triangle.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Consecutive triangles of an instance on the raster, and what became of the others.
struct TrianglesOnRaster {
    uint32_t instance = 0;
    std::vector<ScreenTriangle> triangles;  ///< in the scene's order; those of a clipped triangle follow each other
    uint64_t given = 0;                     ///< of the scene
    uint64_t outside = 0;                   ///< lie beyond one plane of the frustum with all corners
    uint64_t facingAway = 0;                ///< not drawn by the facing rule
    uint64_t withoutSample = 0;             ///< have no area on the raster, or no pixel centre in their box
    uint64_t clipped = 0;                   ///< at the near plane, or where they leave the raster's range
};

/// The triangles of a scene on the raster of a picture, in the scene's order.
struct SceneOnRaster {
    Viewport size;
    std::vector<TrianglesOnRaster> parts;

    [[nodiscard]] size_t triangleCount() const;
};

/// Transforms each vertex once, as OpenGL does: by a float matrix relative to the eye; depth is reversed, 1 at the near plane and
/// 0 at the far plane. Clips at the near plane before the division. Nothing is clipped at the far plane, for what lies beyond it
/// has a depth below 0, which no depth test passes. Triangles that reach beyond 32,000 pixels are clipped there, so that edge
/// functions are exact in 64 bits. `parallel` changes nothing in the result. Throws Error(Usage) for a scene of more than
/// 2^32 − 2 triangles.
[[nodiscard]] SceneOnRaster trianglesOnRaster(const Scene& scene, const View& view, Facing facing, bool parallel = true);

/// A corner in a picture: pixels from its lower left corner, and the reversed depth.
struct RasterCorner {
    double x = 0.0, y = 0.0;
    float depth = 0.0f;
};
/// A triangle from its corners in a picture, both of its sides; none where it covers no sample. `number` is counted from 1.
[[nodiscard]] std::optional<ScreenTriangle> triangleOnRaster(const RasterCorner (&corners)[3], uint32_t number,
                                                             const Viewport& size);

/// Indices of triangles by bands of rows that they reach, in their order.
class RasterBins {
public:
    /// `rows`: of each band.
    RasterBins(const SceneOnRaster& scene, int rows, bool parallel);

    [[nodiscard]] size_t bands() const { return m_begin.empty() ? 0 : m_begin.size() - 1; }
    [[nodiscard]] std::span<const ScreenTriangle* const> band(size_t number) const {
        return std::span(m_triangles).subspan(m_begin[number], m_begin[number + 1] - m_begin[number]);
    }

private:
    std::vector<size_t> m_begin;
    std::vector<const ScreenTriangle*> m_triangles;
};

}  // namespace cullscope
