#include "core/visibility/displaced_surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/clip_polygon.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

/// The most that displacement may move in the picture of a perspective view: a point p, `ahead` of the eye, displaced by d in
/// some direction moves by d |p| / ahead² in the plane one unit ahead. Far aside in a wide view nearly all of this comes from the
/// change of `ahead`.
struct PictureMotion {
    double unit = 0;    ///< d / most, where `most` is the largest motion allowed: motionless is ahead² >= unit |p|
    double secant = 1;  ///< the largest |p| / ahead that the view shows

    [[nodiscard]] bool mayMove(double nearest, double farthest) const {
        return !(nearest >= unit * secant) && !(nearest > 0.0 && nearest * nearest >= unit * farthest);
    }
};

/// Whether a view shows a part of a triangle of the instance that moves too far in the picture. Planes of the frustum lie farther
/// out by `displaced`: a corner may be drawn within them that lies without.
bool showsMoved(const Scene& scene, uint32_t number, const View& view, double displaced, const PictureMotion& motion) {
    const Instance& instance = scene.instances()[number];
    const TriangleMesh& mesh = scene.meshOf(number);
    const Frustum& frustum = view.frustum();
    std::vector<Vec3> shown, buffer;
    const auto mayMove = [&] {
        double nearest = std::numeric_limits<double>::infinity(), farthest = 0.0;
        for (const Vec3& corner : shown) {
            nearest = std::min(nearest, glm::dot(frustum.forward, corner));
            farthest = std::max(farthest, glm::length(corner));
        }
        return motion.mayMove(nearest, farthest);
    };
    for (size_t first = 0; first < mesh.indices().size(); first += 3) {
        shown.resize(3);
        for (size_t i = 0; i < 3; ++i) {
            const Vec4 position(mesh.position(mesh.indices()[first + i]), 1.0);
            shown[i] = Vec3(instance.worldFromMesh * position) - view.eye();
        }
        if (!mayMove()) continue;
        for (size_t plane = 0; plane < size_t(FrustumPlane::Far); ++plane)
            clipPolygon(shown, buffer, [&](const Vec3& corner) { return frustum.planes[plane].distance(corner) + displaced; });
        if (!shown.empty() && mayMove()) return true;
    }
    return false;
}

/// surfacesStandStill of a parallel view: no object of which it may show anything is displaced farther.
bool standStillInParallel(const Scene& scene, const View& view) {
    const Frustum& frustum = view.frustum();
    const double pixel = 2.0 * std::min(frustum.halfWidth / view.viewport().width, frustum.halfHeight / view.viewport().height);
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const EyeBounds bounds = boundsFromEye(scene, i, view.eye());
        const Vec3& centre = bounds.sphere.centre;
        const double aside = std::hypot(glm::dot(frustum.right, centre), glm::dot(frustum.up, centre)) + bounds.sphere.radius;
        const double displaced = 0x1p-21 * aside + scene.pictureRounding(scene.instances()[i]);
        if (displaced <= kMostDisplacedPixels * pixel) continue;
        const auto rejects = [&](const Plane& plane) { return farthestInside(plane, bounds) < -bounds.margin; };
        if (std::ranges::none_of(frustum.planes, rejects)) return false;
    }
    return true;
}

}  // namespace

bool surfacesStandStill(const Scene& scene, const View& view) {
    const Frustum& frustum = view.frustum();
    if (frustum.parallel()) return standStillInParallel(scene, view);
    const Viewport& size = view.viewport();
    const double pixel = 2.0 * std::min(frustum.tanHalfWidth / size.width, frustum.tanHalfHeight / size.height);
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const EyeBounds bounds = boundsFromEye(scene, i, view.eye());
        // Half the margin of a plane test is the picture's share of it.
        const double displaced = 0.5 * bounds.margin + scene.pictureRounding(scene.instances()[i]);
        if (farthestAhead(bounds.box, frustum) < frustum.nearDistance - displaced) continue;
        const PictureMotion motion{displaced / (kMostDisplacedPixels * pixel),
                                   glm::length(Vec3(frustum.tanHalfWidth, frustum.tanHalfHeight, 1.0))};
        const double nearest = std::max(nearestAhead(bounds.box, frustum), frustum.nearDistance);
        if (!motion.mayMove(nearest, glm::length(bounds.box.centre) + glm::length(bounds.box.halfExtent))) continue;
        if (showsMoved(scene, i, view, displaced, motion)) return false;
    }
    return true;
}

Promise promiseWhereSurfacesStandStill(Promise promise, const Scene& scene, const View& view) {
    return surfacesStandStill(scene, view) ? promise : Promise::Approximate;
}

}  // namespace cullscope
