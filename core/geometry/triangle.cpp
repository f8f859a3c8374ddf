#include "core/geometry/triangle.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cullscope {

double nearestDistance(const TriangleCorners& corners) {
    const auto& [a, b, c] = corners;
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 normal = glm::cross(ab, ac);
    const double area = glm::dot(normal, normal);
    if (area > 0.0) {
        // The foot of the perpendicular, where it lies inside.
        const Vec3 foot = glm::dot(a, normal) / area * normal;
        const bool inside = glm::dot(glm::cross(b - a, foot - a), normal) >= 0.0 &&
                            glm::dot(glm::cross(c - b, foot - b), normal) >= 0.0 &&
                            glm::dot(glm::cross(a - c, foot - c), normal) >= 0.0;
        if (inside) return glm::length(foot);
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < 3; ++i) {
        const Vec3& from = corners[i];
        const Vec3 way = corners[(i + 1) % 3] - from;
        const double length = glm::dot(way, way);
        const double share = length > 0.0 ? std::clamp(-glm::dot(from, way) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::length(from + share * way));
    }
    return nearest;
}

double solidAngle(const TriangleCorners& corners) {
    const auto& [a, b, c] = corners;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double turned = glm::dot(a, glm::cross(b, c));
    return 2.0 * std::atan2(turned, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

}  // namespace cullscope
