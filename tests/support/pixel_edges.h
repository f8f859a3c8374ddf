#pragma once

#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope::test {

/// The edges of triangles in a picture, in long double, without sharing code with the renderer or the rays: its own basis from
/// the camera's parameters, its own transform, clipping at the near and far planes before the division (a clipped edge counts as
/// an edge).
class PixelEdges {
public:
    PixelEdges(const Scene& scene, const Camera& camera, const Viewport& viewport);

    /// The distance in pixels from a pixel's centre to the nearest edge of a scene triangle; infinity where no part of it is in
    /// view. Pixels count row by row from the bottom.
    [[nodiscard]] double toEdgeOf(uint64_t triangle, size_t pixel) const;
    /// Twice the area of a triangle in the picture over its perimeter, in pixels: the radius of its inscribed circle. Corners
    /// that move by less than about this much do not turn it around. 0 where no part of it is in view.
    [[nodiscard]] double inscribedRadius(uint64_t triangle) const;

private:
    using Real = long double;
    struct Pixel {
        Real x, y;
    };
    static Real toSegment(const Pixel& p, const Pixel& a, const Pixel& b);
    /// The corners in the picture of what the near and far planes leave of a triangle.
    [[nodiscard]] std::vector<Pixel> cornersOf(uint64_t triangle) const;
    struct Point {
        Real right, up, forward;
    };
    [[nodiscard]] Point fromEye(const Vec3& origin, const Mat3& linear, const Vec3& translation, const Vec3f& position) const;

    const Scene& m_scene;
    Camera m_camera;
    Viewport m_viewport;
    Real m_tanHalfHeight = 0, m_tanHalfWidth = 0;
    std::array<std::array<Real, 3>, 3> m_axes{};  ///< right, up, forward
};

/// The raster's snapping moves an edge by less than this: vertices snap to 1/256 pixel, which moves an edge by at most 1/256 · √2
/// / 2.
inline constexpr double kEdgePixels = 1.0 / 128;

}  // namespace cullscope::test
