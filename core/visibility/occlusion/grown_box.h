#pragma once

#include "core/scene/camera.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope::occlusion {

/// A box relative to the eye as OpenGL is asked about it.
struct GrownBox {
    EyeBox box;           ///< grown
    double growth = 0.0;  ///< of each side, world units
};

/// A box relative to the eye, grown by boxGrowth; `margin`: of its plane tests.
[[nodiscard]] inline GrownBox grownBox(const EyeBox& box, double margin, const View& view) {
    const double growth = boxGrowth(box, margin, view);
    return {{box.centre, box.halfExtent + Vec3(growth)}, growth};
}

/// The same of a box of the world.
[[nodiscard]] inline GrownBox grownBox(const Box3& world, const View& view) {
    const EyeBox box = relativeToEye(world, view.eye());
    return grownBox(box, marginFromEye(world.centre(), box.centre, glm::length(box.halfExtent), view.eye()), view);
}

/// Whether OpenGL can answer about a grown box: it is drawn in place, and lies wholly beyond the near plane. A box that holds a
/// point of the near rectangle covers no sample, and depths of what crosses the plane of the eye mean nothing.
[[nodiscard]] inline bool canBeAskedAbout(const GrownBox& box, const View& view) {
    return isDrawnInPlace(box.box, view.frustum()) && nearestAhead(box.box, view.frustum()) > view.frustum().nearDistance;
}

}  // namespace cullscope::occlusion
