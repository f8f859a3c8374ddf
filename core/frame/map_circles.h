#pragma once

#include <cmath>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

/// Circles about an axis on the sphere of directions, at equal steps of the angle α from the axis; β is the angle about it.
struct MapCircles {
    Vec3 axis{0.0, 0.0, 1.0};  ///< unit vector: α = 0
    Vec3 side{1.0, 0.0, 0.0};  ///< unit vector perpendicular to the axis: β = 0
    Vec3 over{0.0, 1.0, 0.0};  ///< axis × side: β = 90°
    double width = 0.0;        ///< the step of α, in radians
    uint32_t bands = 0;        ///< between the circles, the ends at 0 and 180° among them
    uint32_t every = 1;        ///< in a small map with numbers at the circles, only every n-th one is drawn

    /// The unit direction at α, β (radians).
    [[nodiscard]] Vec3 direction(double alpha, double beta) const {
        return std::cos(alpha) * axis + std::sin(alpha) * (std::cos(beta) * side + std::sin(beta) * over);
    }
};

/// The directions at one angle α from the axis, as points (θ, φ), φ continued over the seam: the last point is the first, or
/// differs from it by a whole turn where the circle goes around a pole.
[[nodiscard]] std::vector<Vec2> circleOnMap(const MapCircles& circles, double alpha);

/// The same, cut at the seam.
struct CutCircle {
    double alpha = 0.0;
    /// As lines on the map through points (θ, φ) in radians, cut where the curve goes over the seam, φ in [0, 2π].
    std::vector<std::vector<Vec2>> lines;
};
/// The circles by ascending α, without the start (α = 0) and the end (α = 180°), which are points.
[[nodiscard]] std::vector<CutCircle> cutCircles(const MapCircles& circles);

/// The directions at one angle β about the axis, from α = 0 to 180°, as lines of (θ, φ) whose φ continues over the seam. There
/// are two lines if they pass over a pole of the map.
[[nodiscard]] std::vector<std::vector<Vec2>> meridianOnMap(const MapCircles& circles, double beta);

}  // namespace cullscope
