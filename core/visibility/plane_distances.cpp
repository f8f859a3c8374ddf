#include "core/visibility/plane_distances.h"

#include "core/visibility/eye_bounds.h"

namespace cullscope {

std::vector<PlaneDistance> planeDistances(const Scene& scene, const View& view, uint32_t instance) {
    const EyeBounds bounds = boundsFromEye(scene, instance, view.eye());
    std::vector<PlaneDistance> distances;
    for (size_t i = 0; i < view.frustum().planes.size(); ++i) {
        const Plane& plane = view.frustum().planes[i];
        PlaneDistance one{static_cast<FrustumPlane>(i), farthestInside(plane, bounds), bounds.margin, Containment::Straddles};
        if (one.distance < -one.bound) one.containment = Containment::Outside;
        if (farthestOutside(plane, bounds) > one.bound) one.containment = Containment::Inside;
        distances.push_back(one);
    }
    return distances;
}

}  // namespace cullscope
