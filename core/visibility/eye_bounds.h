#pragma once

#include <algorithm>

#include "core/geometry/frustum.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The bounds of one object, relative to the eye, and how far a plane test of them leans outward (geometry/frustum.h,
/// conservativeMargin).
struct EyeBounds {
    EyeBox box;
    Sphere sphere;
    double margin = 0.0;
};

/// The margin of something that lies around `world` with the given reach; `fromEye` is the same place relative to the eye.
[[nodiscard]] inline double marginFromEye(const Vec3& world, const Vec3& fromEye, double reach, const Vec3& eye) {
    // The subtraction's rounding counts in world coordinates, the picture's in distances from the eye.
    return conservativeMargin(glm::length(fromEye) + reach) + (glm::length(world) + glm::length(eye) + reach) * 0x1p-49;
}

/// Of an instance of the scene.
[[nodiscard]] inline EyeBounds boundsFromEye(const Scene& scene, uint32_t instance, const Vec3& eye) {
    EyeBounds bounds;
    bounds.box = relativeToEye(scene.instanceBox(instance), eye);
    const Sphere& sphere = scene.instanceSphere(instance);
    bounds.sphere = {sphere.centre - eye, sphere.radius};
    bounds.margin = marginFromEye(sphere.centre, bounds.sphere.centre, sphere.radius, eye);
    return bounds;
}

/// Signed distance of the bounds' point farthest inside; below 0 by more than the margin, the object is outside. The tighter of
/// sphere and box decides.
[[nodiscard]] inline double farthestInside(const Plane& plane, const EyeBounds& bounds) {
    return std::min(plane.distance(bounds.sphere.centre) + bounds.sphere.radius, pVertexDistance(plane, bounds.box));
}

/// The same of the point farthest outside; above 0 by more than the margin, all of the object is inside this plane.
[[nodiscard]] inline double farthestOutside(const Plane& plane, const EyeBounds& bounds) {
    return std::max(plane.distance(bounds.sphere.centre) - bounds.sphere.radius,
                    plane.distance(bounds.box.centre) - glm::dot(glm::abs(plane.normal), bounds.box.halfExtent));
}

}  // namespace cullscope
