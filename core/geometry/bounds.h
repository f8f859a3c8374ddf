#pragma once

#include <limits>
#include <span>

#include "core/geometry/types.h"

namespace cullscope {

/// An axis-aligned box; empty (min > max) until a point or box is added.
struct Box3 {
    Vec3 min{std::numeric_limits<double>::infinity()};
    Vec3 max{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
    [[nodiscard]] Vec3 centre() const { return 0.5 * min + 0.5 * max; }
    /// Half the edge lengths.
    [[nodiscard]] Vec3 halfExtent() const { return 0.5 * max - 0.5 * min; }
    [[nodiscard]] double diagonal() const { return empty() ? 0.0 : 2.0 * glm::length(halfExtent()); }
    void add(const Vec3& point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    void add(const Box3& other) {
        min = glm::min(min, other.min);
        max = glm::max(max, other.max);
    }
};

struct Sphere {
    Vec3 centre{0.0};
    double radius = 0.0;
};

/// The smallest axis-aligned box around a transformed box, rounded outward: it contains every point of `box` transformed in
/// double. `transform` is affine.
[[nodiscard]] Box3 transformed(const Box3& box, const Mat4& transform);

/// A sphere around points, at most a few per cent larger than the smallest (Ritter 1990, then the better of it and the
/// box-centred sphere); its radius is rounded outward, so that it contains every point. Empty input: radius 0 at the origin.
[[nodiscard]] Sphere boundingSphere(std::span<const Vec3f> points);

/// A sphere around a transformed sphere: the radius is multiplied by the largest stretch of `transform` (affine), rounded
/// outward.
[[nodiscard]] Sphere transformed(const Sphere& sphere, const Mat4& transform);

}  // namespace cullscope
