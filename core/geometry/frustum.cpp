#include "core/geometry/frustum.h"

#include <limits>

namespace cullscope {

std::array<Vec3, 8> Frustum::corners() const {
    std::array<Vec3, 8> corners;
    for (int depth = 0; depth < 2; ++depth) {
        const double distance = depth == 0 ? nearDistance : farDistance;
        const Vec3 centre = forward * distance;
        const Vec3 x = right * halfWidthAt(distance);
        const Vec3 y = up * halfHeightAt(distance);
        corners[depth * 4 + 0] = centre - x - y;
        corners[depth * 4 + 1] = centre + x - y;
        corners[depth * 4 + 2] = centre + x + y;
        corners[depth * 4 + 3] = centre - x + y;
    }
    return corners;
}

Frustum makeFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double tanHalfWidth, double tanHalfHeight,
                    double nearDistance, double farDistance) {
    Frustum frustum;
    frustum.forward = forward;
    frustum.right = right;
    frustum.up = up;
    frustum.tanHalfWidth = tanHalfWidth;
    frustum.tanHalfHeight = tanHalfHeight;
    frustum.nearDistance = nearDistance;
    frustum.farDistance = farDistance;
    // A point p is inside the right plane where p·right <= tan·(p·forward).
    const auto side = [&](const Vec3& axis, double tangent) { return Plane{glm::normalize(forward * tangent + axis), 0.0}; };
    frustum.planes = {side(right, tanHalfWidth), side(-right, tanHalfWidth),    side(up, tanHalfHeight),
                      side(-up, tanHalfHeight),  Plane{forward, -nearDistance}, Plane{-forward, farDistance}};
    return frustum;
}

Frustum makeParallelFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double halfWidth, double halfHeight,
                            double nearDistance, double farDistance) {
    Frustum frustum;
    frustum.forward = forward;
    frustum.right = right;
    frustum.up = up;
    frustum.tanHalfWidth = frustum.tanHalfHeight = 0.0;
    frustum.halfWidth = halfWidth;
    frustum.halfHeight = halfHeight;
    frustum.nearDistance = nearDistance;
    frustum.farDistance = farDistance;
    frustum.planes = {Plane{right, halfWidth},
                      Plane{-right, halfWidth},
                      Plane{up, halfHeight},
                      Plane{-up, halfHeight},
                      Plane{forward, -frustum.leastDistance()},
                      Plane{-forward, frustum.mostDistance()}};
    return frustum;
}

EyeBox relativeToEye(const Box3& box, const Vec3& eye) {
    const Vec3 rounding =
        (glm::abs(eye) + glm::max(glm::abs(box.min), glm::abs(box.max))) * (4 * std::numeric_limits<double>::epsilon());
    return {box.centre() - eye, box.halfExtent() + rounding};
}

namespace {

/// Combines the results of the six planes: outside one plane is outside, inside all planes is inside.
template <typename ClassifyPlane>
Containment combined(const Frustum& frustum, const ClassifyPlane& classifyPlane) {
    Containment result = Containment::Inside;
    for (const Plane& plane : frustum.planes) {
        const Containment side = classifyPlane(plane);
        if (side == Containment::Outside) return Containment::Outside;
        if (side == Containment::Straddles) result = Containment::Straddles;
    }
    return result;
}

}  // namespace

Containment classify(const Frustum& frustum, const EyeBox& box) {
    const double margin = conservativeMargin(glm::length(box.centre) + glm::length(box.halfExtent));
    return combined(frustum, [&](const Plane& plane) { return classify(plane, box, margin); });
}

Containment classify(const Frustum& frustum, const Sphere& eyeSphere) {
    const double margin = conservativeMargin(glm::length(eyeSphere.centre) + eyeSphere.radius);
    return combined(frustum, [&](const Plane& plane) {
        const double distance = plane.distance(eyeSphere.centre);
        if (distance + eyeSphere.radius < -margin) return Containment::Outside;
        return distance - eyeSphere.radius > margin ? Containment::Inside : Containment::Straddles;
    });
}

}  // namespace cullscope
