#pragma once

#include <algorithm>
#include <vector>

#include "core/visibility/overlay.h"

namespace cullscope::test {

/// The distance of a place from the nearest of the lines.
inline double distanceTo(const std::vector<LineSegment>& lines, const Vec3& place) {
    double least = 1e300;
    for (const LineSegment& line : lines) {
        const Vec3 along = line.to - line.from;
        const double squared = glm::dot(along, along);
        const double t = squared > 0.0 ? std::clamp(glm::dot(place - line.from, along) / squared, 0.0, 1.0) : 0.0;
        least = std::min(least, glm::distance(place, line.from + t * along));
    }
    return least;
}

}  // namespace cullscope::test
