#pragma once

#include <functional>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

/// A line on the map along directions: points (θ, φ) in radians, φ continued over the seam, so close to each other that the line
/// looks as it is bent.
class MapLine {
public:
    explicit MapLine(const Vec3& start);

    /// Goes on along at(from) … at(to), of which the beginning is the last point.
    void follow(const std::function<Vec3(double)>& at, double from, double to);
    /// Goes on along the great circle from `from`, the last direction, to one less than half a turn away. A pole, which has every
    /// azimuth, takes that at which the line leaves it.
    void arc(const Vec3& from, const Vec3& to);

    [[nodiscard]] std::vector<Vec2> take() && { return std::move(m_points); }

private:
    void halve(const std::function<Vec3(double)>& at, double from, double to, int halvings);
    void add(Vec2 angles);

    std::vector<Vec2> m_points;
};

}  // namespace cullscope
