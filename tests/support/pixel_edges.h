#pragma once

#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope::test {

/// Where triangles lie in a picture, in long double and sharing no code with the renderer or the rays: own basis from the
/// camera's numbers, own transform, cut at the near and far planes before the division (a cut is an edge like any other).
class PixelEdges {
public:
    PixelEdges(const Scene& scene, const Camera& camera, const Viewport& viewport);

    /// Distance in pixels from a pixel's centre to the nearest edge of a scene triangle; infinity where none of it is in view.
    /// Pixels count row by row from the bottom.
    [[nodiscard]] double toEdgeOf(uint64_t triangle, size_t pixel) const;

private:
    using Real = long double;
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

/// The raster's snapping moves an edge by less than this: vertices go to 1/256 pixel, an edge by at most 1/256 · √2 / 2 with it.
inline constexpr double kEdgePixels = 1.0 / 128;

}  // namespace cullscope::test
