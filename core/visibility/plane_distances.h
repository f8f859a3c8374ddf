#pragma once

#include <vector>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The distance of an object's bounds (the tighter of box and sphere) from one plane of a view, computed independently of the
/// strategy.
struct PlaneDistance {
    FrustumPlane plane = FrustumPlane::Left;
    double distance = 0.0;  ///< signed, of the point farthest inside, scene units
    double bound = 0.0;     ///< outside only where distance < −bound (geometry/frustum.h, conservativeMargin)
    Containment containment = Containment::Straddles;
};

/// The distances of an instance of the scene from the six planes, in their order.
[[nodiscard]] std::vector<PlaneDistance> planeDistances(const Scene& scene, const View& view, uint32_t instance);

}  // namespace cullscope
