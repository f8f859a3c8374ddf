#pragma once

#include <functional>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

/// A line on the map along directions: points (θ, φ) in radians, φ continued over the seam, close enough for the line to look
/// smooth.
class MapLine {
public:
    explicit MapLine(const Vec3& start);

    /// Continues along at(from) … at(to); at(from) is the current last point.
    void follow(const std::function<Vec3(double)>& at, double from, double to);
    /// Continues along the great circle from `from`, the last direction, to one less than half a turn away. At a pole, which has
    /// every azimuth, the point gets the azimuth of the rest of the line.
    void arc(const Vec3& from, const Vec3& to);

    [[nodiscard]] std::vector<Vec2> take() && { return std::move(m_points); }

private:
    void halve(const std::function<Vec3(double)>& at, double from, double to, int halvings);
    void add(Vec2 angles);

    std::vector<Vec2> m_points;
};

}  // namespace cullscope
