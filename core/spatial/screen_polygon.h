#pragma once

#include <limits>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// What the picture shows of a convex polygon before the near plane. Coordinates in pixels, y upward.
struct ScreenPolygon {
    std::vector<Vec2> points;  ///< counter-clockwise; empty: nothing of it lies in the picture
    double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
    double near = 0.0, far = 0.0;  ///< the least and largest forward distance, in scene units
    Vec3 inverse{0.0};             ///< 1 / forward distance of its plane at (x, y): inverse.x · x + inverse.y · y + inverse.z

    [[nodiscard]] double inverseAt(const Vec2& at) const { return inverse.x * at.x + inverse.y * at.y + inverse.z; }
};

/// Projects polygons for one view.
class ScreenProjection {
public:
    explicit ScreenProjection(const View& view);

    /// `corners`: relative to the eye, not all in a plane with the eye; `normal`: of their plane.
    [[nodiscard]] ScreenPolygon project(const std::vector<Vec3>& corners, const Vec3& normal) const;

private:
    Vec3 m_forward, m_right,
        m_up;  ///< right and up are scaled: their components are pixels from the middle at forward distance 1
    double m_near, m_width, m_height;
};

/// Where two projections overlap.
struct Overlap {
    /// Projections that overlap by less than this many pixels count as apart: the raster snaps corners to 1/256 pixel.
    static constexpr double kApart = 1.0 / 1024;

    double thickness = 0.0;  ///< pixels, in the direction in which it is least
    /// The first polygon's inverse distance less the second one's, over the overlap: above 0 where the first is nearer. Within
    /// rounding it is 0.
    double leastBefore = std::numeric_limits<double>::infinity();
    double mostBefore = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const { return thickness <= kApart || leastBefore > mostBefore; }
};
[[nodiscard]] Overlap overlapOf(const ScreenPolygon& first, const ScreenPolygon& second);

}  // namespace cullscope
