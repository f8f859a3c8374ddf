#pragma once

#include <array>

#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/spherical/decision.h"
#include "core/visibility/trace.h"

namespace cullscope::spherical {

/// An instance as a view sees it, in the coordinates of its mesh's maps: sight lines stay sight lines under any affine transform,
/// so that instances of one mesh share its maps.
struct ObjectSpaceView {
    /// One plane's test of the bounding sphere (in the world an ellipsoid), as in a trace: world units.
    struct PlaneTest {
        Containment containment = Containment::Straddles;
        double distance = 0.0;  ///< of the sphere's point farthest inside
        double bound = 0.0;
    };

    SphereRelation relation = SphereRelation::AroundEye;
    std::array<PlaneTest, 6> planes{};
    size_t planesTested = 0;  ///< tests end at the first plane with all of the sphere outside
    Vec3 eye{0.0};
    std::array<Vec3, 4>
        cornerDirections{};   ///< from the eye to the near plane's corners: bottom-left, bottom-right, top-right, top-left
    bool beyondNear = false;  ///< the whole sphere lies behind the near plane, so that nothing of it is cut off
    double pixelReach = 0.0;  ///< how far in map units a point moves, at most, that moves by one pixel

    /// The frustum's planes on points of the map: normal · p + offset is the distance in world units; normals are of any length.
    std::array<Plane, 6> planesOnMap{};
    double margin = 0.0;      ///< of distances from them (geometry/frustum.h, conservativeMargin)
    bool eyeKnown = false;    ///< false: the object is flat, and no point of the map is the eye's
    double unevenness = 1.0;  ///< the longest over the shortest image of a length of the map
    double pixelSlope = 0.0;  ///< a pixel's width over its distance
};

/// Outside is never said of a sphere that reaches into the frustum (bound: geometry/frustum.h, conservativeMargin).
/// `sphere`: the mesh's bounding sphere, relative to its origin.
[[nodiscard]] ObjectSpaceView objectSpaceView(const Scene& scene, uint32_t instance, const Sphere& sphere, const View& view);

}  // namespace cullscope::spherical
