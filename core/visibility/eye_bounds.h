#pragma once

#include <algorithm>

#include "core/geometry/frustum.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The bounds of one object, relative to the eye, and the margin of their plane tests (geometry/frustum.h, conservativeMargin).
struct EyeBounds {
    EyeBox box;
    Sphere sphere;
    double margin = 0.0;
};

/// The margin of a plane test for an object around `world` with the given reach; `fromEye` is the same place relative to the eye.
[[nodiscard]] inline double marginFromEye(const Vec3& world, const Vec3& fromEye, double reach, const Vec3& eye) {
    // The rounding of the subtraction grows with the world coordinates, that of the picture with the distance from the eye.
    return conservativeMargin(glm::length(fromEye) + reach) + (glm::length(world) + glm::length(eye) + reach) * 0x1p-49;
}

/// The bounds of an instance of the scene.
[[nodiscard]] inline EyeBounds boundsFromEye(const Scene& scene, uint32_t instance, const Vec3& eye) {
    EyeBounds bounds;
    bounds.box = relativeToEye(scene.instanceBox(instance), eye);
    const Sphere& sphere = scene.instanceSphere(instance);
    bounds.sphere = {sphere.centre - eye, sphere.radius};
    bounds.margin = marginFromEye(sphere.centre, bounds.sphere.centre, sphere.radius, eye);
    return bounds;
}

/// Signed distance of the bounds' point farthest inside the plane, by the tighter of sphere and box. The object is outside where
/// it is below −margin.
[[nodiscard]] inline double farthestInside(const Plane& plane, const EyeBounds& bounds) {
    return std::min(plane.distance(bounds.sphere.centre) + bounds.sphere.radius, pVertexDistance(plane, bounds.box));
}

/// The same for the point farthest outside; the whole object is inside the plane where it is above the margin.
[[nodiscard]] inline double farthestOutside(const Plane& plane, const EyeBounds& bounds) {
    return std::max(plane.distance(bounds.sphere.centre) - bounds.sphere.radius,
                    plane.distance(bounds.box.centre) - glm::dot(glm::abs(plane.normal), bounds.box.halfExtent));
}

/// The distance ahead of the eye of a box's point farthest ahead, or nearest; below 0 behind the eye.
[[nodiscard]] inline double farthestAhead(const EyeBox& box, const Frustum& frustum) {
    return glm::dot(frustum.forward, box.centre) + glm::dot(glm::abs(frustum.forward), box.halfExtent);
}
[[nodiscard]] inline double nearestAhead(const EyeBox& box, const Frustum& frustum) {
    return glm::dot(frustum.forward, box.centre) - glm::dot(glm::abs(frustum.forward), box.halfExtent);
}

/// Whether OpenGL draws a box where it is: its coordinates are numbers of float, and it is at most 2^16 times as wide or high as
/// the view at its nearest distance that is seen. The corners that clipping makes are interpolated in float along its edges: of a
/// larger box they may miss the view, though the box covers it.
[[nodiscard]] inline bool isDrawnInPlace(const EyeBox& box, const Frustum& frustum) {
    constexpr double kMostViews = 0x1p16;
    if (!(glm::length(box.centre) + glm::length(box.halfExtent) < 1e30)) return false;
    const double nearest = std::max(nearestAhead(box, frustum), frustum.nearDistance);
    const auto reach = [&](const Vec3& axis) {
        return std::abs(glm::dot(axis, box.centre)) + glm::dot(glm::abs(axis), box.halfExtent);
    };
    return reach(frustum.right) <= kMostViews * frustum.halfWidthAt(nearest) &&
           reach(frustum.up) <= kMostViews * frustum.halfHeightAt(nearest);
}

/// A pixel's width in world units at the box's farthest distance ahead: by so much a box grows before OpenGL is asked about it.
[[nodiscard]] inline double pixelAtFarthest(const EyeBox& box, const View& view) {
    const double farthest = std::max(farthestAhead(box, view.frustum()), 0.0);
    return 2.0 * view.frustum().halfHeightAt(farthest) / view.viewport().height;
}

/// By how much a box grows on each side for the rounding of a picture, in world units: twice the margin of a plane test
/// (`margin`), for the float rounding of the box and of what it holds; and a bound on the error of an interpolated depth: four
/// roundings of the depth at the box's nearest distance, seen at its farthest.
[[nodiscard]] inline double boxRounding(const EyeBox& box, double margin, const View& view) {
    const Frustum& frustum = view.frustum();
    const double farthest = std::max(farthestAhead(box, frustum), 0.0);
    const double nearest = std::max(nearestAhead(box, frustum), frustum.nearDistance);
    // A rounding of the depth, as a distance.
    const double rounding = frustum.parallel() ? depthRoom(frustum.farDistance) : 0x1p-22 * farthest * (farthest / nearest);
    return 2.0 * margin + rounding;
}

/// By how much a box grows on each side before OpenGL is asked about it, in world units: its rounding, and a pixel's width at its
/// farthest distance.
[[nodiscard]] inline double boxGrowth(const EyeBox& box, double margin, const View& view) {
    return pixelAtFarthest(box, view) + boxRounding(box, margin, view);
}

}  // namespace cullscope
