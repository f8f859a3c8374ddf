#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope::test {

/// At how many samples of a picture, away from edges, the polygon that is drawn last is not the nearest one. `polygons`: in the
/// order in which they are drawn, their corners relative to the eye.
inline size_t wrongSamples(const std::vector<std::vector<Vec3>>& polygons, const View& view) {
    size_t wrong = 0;
    const Viewport size = view.viewport();
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const Vec3 along = view.direction(x + 0.5, y + 0.5);
            double last = 0.0, nearest = 1e300;
            bool nearAnEdge = false;
            for (const std::vector<Vec3>& corners : polygons) {
                Vec3 normal(0.0);
                for (size_t i = 2; i < corners.size(); ++i)
                    normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
                const double distance = glm::dot(normal, corners[0]) / glm::dot(normal, along);
                if (!(distance > view.frustum().nearDistance)) continue;
                double inside = 1e300;
                for (size_t i = 0; i < corners.size(); ++i) {
                    const Vec3 &a = corners[i], &b = corners[(i + 1) % corners.size()];
                    const double length = glm::length(b - a) * glm::length(normal);
                    if (length > 0.0)
                        inside = std::min(inside, glm::dot(glm::cross(b - a, distance * along - a), normal) / length);
                }
                nearAnEdge = nearAnEdge || std::abs(inside) < 1e-2;
                if (inside <= 0.0) continue;
                last = distance;
                nearest = std::min(nearest, distance);
            }
            wrong += !nearAnEdge && last > nearest * (1.0 + 1e-6) ? 1 : 0;
        }
    return wrong;
}

}  // namespace cullscope::test
