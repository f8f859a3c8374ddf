#pragma once

#include "core/geometry/types.h"

namespace cullscope {

/// The plane { p : normal·p + offset = 0 }; the normal has unit length and points to the inside.
struct Plane {
    Vec3 normal{0.0, 0.0, 1.0};
    double offset = 0.0;

    /// Signed distance, positive inside.
    [[nodiscard]] double distance(const Vec3& point) const { return glm::dot(normal, point) + offset; }
};

}  // namespace cullscope
