#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "core/frame/draw_list.h"
#include "core/raster/screen_triangle.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

// From a mesh's positions to triangles on the raster, one by one; for the source files of this folder. All operations are those
// of llvmpipe in their order, in 32-bit floats: so depths are equal to the bit, and of surfaces in one plane the same one is
// seen.

namespace cullscope {

using Clip = float __attribute__((vector_size(16)));  // x, y, z, w

/// Beyond which planes a vertex lies, in the order in which triangles are clipped.
struct Beyond {
    enum : uint32_t { Right = 1, Left = 2, Top = 4, Bottom = 8, Far = 16, Near = 32, Unprojectable = 64 };
    static constexpr int kPlanes = 6;
};

/// From the positions of an instance's mesh to the picture.
class Projection {
public:
    Projection(const View& view, const Scene& scene, size_t instance)
        : m_halfWidth(0.5f * float(view.viewport().width)), m_halfHeight(0.5f * float(view.viewport().height)) {
        const Mat4f matrix = view.clipFromPositions(scene.instances()[instance].worldFromMesh, scene.meshOf(instance).origin());
        for (int c = 0; c < 4; ++c) m_columns[size_t(c)] = Clip{matrix[c].x, matrix[c].y, matrix[c].z, matrix[c].w};
    }

    /// For the kernels, which do the same.
    [[nodiscard]] RasterProjection forKernels() const;
    [[nodiscard]] Clip clip(const Vec3f& position) const {
        return ((m_columns[0] * position.x + m_columns[1] * position.y) + m_columns[2] * position.z) + m_columns[3];
    }
    [[nodiscard]] static uint32_t beyond(const Clip& clip);
    [[nodiscard]] RasterVertex vertex(const Clip& clip) const;
    /// A corner that clipping made.
    [[nodiscard]] RasterVertex clippedVertex(const Clip& clip) const;

private:
    std::array<Clip, 4> m_columns;
    float m_halfWidth, m_halfHeight;
};

/// A place of a vertex as a whole number of 1/256 pixel from the centre of the first pixel.
[[nodiscard]] inline int32_t snapped(float pixels) { return int32_t(std::lrintf((pixels - 0.5f) * float(kSubPixels))); }

/// The corners of a triangle, of which none lies beyond a plane.
struct RasterCorners {
    RasterCorners(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c)
        : vertices{a, b, c}, x{snapped(a.x), snapped(b.x), snapped(c.x)}, y{snapped(a.y), snapped(b.y), snapped(c.y)} {}

    /// Twice the area in units of 1/256 pixel, above 0 where the corners are in counter-clockwise order.
    [[nodiscard]] int64_t twiceArea() const {
        return int64_t(x[1] - x[0]) * (y[2] - y[0]) - int64_t(x[2] - x[0]) * (y[1] - y[0]);
    }

    RasterVertex vertices[3];
    int32_t x[3], y[3];
};

/// The triangle of three corners on the raster; none where its box has no pixel centre. `area` is its twiceArea, and not 0.
[[nodiscard]] std::optional<ScreenTriangle> screenTriangle(const RasterCorners& corners, int64_t area, uint32_t number,
                                                           const Viewport& size);

/// A triangle's depth at a pixel.
[[nodiscard]] inline float depthOf(const ScreenTriangle& triangle, int column, int row) {
    const float depth =
        std::fma(triangle.depthPerRow, float(row), std::fma(triangle.depthPerColumn, float(column), triangle.depth));
    return depth > 1.0f ? 1.0f : depth;
}
/// Whether a pixel belongs to a triangle.
[[nodiscard]] bool coversCentre(const ScreenTriangle& triangle, int column, int row);

/// What became of a triangle on its way to the raster.
enum class RasterFate { OnRaster, FacingAway, WithoutSample };

/// Which sides of an instance's triangles are drawn.
struct RasterFacing {
    RasterFacing() = default;  ///< both
    RasterFacing(const Scene& scene, size_t instance, Facing facing);

    [[nodiscard]] bool drops(int64_t area) const { return front && (area < 0) != mirrored; }

    bool front = false, mirrored = false;
};

/// The triangles of a clipped triangle are at most so many.
inline constexpr size_t kMostPieces = 13;

/// The corners of what is left of a triangle where it is clipped at those of the frustum's planes beyond which a corner lies;
/// less than three where nothing is. Its pieces are the triangles of corners i - 1, i and 0, for i from 2.
struct ClippedCorners {
    std::array<RasterVertex, kMostPieces + 2> corners;
    size_t count = 0;
};
[[nodiscard]] ClippedCorners clippedCorners(const Projection& projection, const std::array<Clip, 3>& corners);

/// Appends the pieces of a triangle that are left where it is clipped (clippedCorners). Its corners are given in clip space.
RasterFate addClipped(const Projection& projection, const std::array<Clip, 3>& corners, const RasterFacing& facing,
                      uint32_t number, const Viewport& size, std::vector<ScreenTriangle>& triangles);

}  // namespace cullscope
