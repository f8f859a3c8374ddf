#pragma once

#include <array>

#include "core/spatial/spherical_maps.h"
#include "core/visibility/object_record.h"
#include "core/visibility/part_view.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// An instance as seen by a view, in the coordinates of its mesh's maps.
struct ObjectSpaceView : PartView {
    /// The test of the bounding sphere (an ellipsoid in the world) against one plane, in world units.
    struct PlaneTest {
        Containment containment = Containment::Straddles;
        double distance = 0.0;  ///< of the sphere's point farthest inside
        double outer = 0.0;     ///< of its point farthest outside
        double bound = 0.0;
    };

    SphereRelation relation = SphereRelation::AroundEye;
    std::array<PlaneTest, 6> planes{};
    size_t planesTested = 0;  ///< tests end at the first plane that the sphere lies outside of
    std::array<Vec3, 4>
        cornerDirections{};   ///< from the eye to the near plane's corners: bottom-left, bottom-right, top-right, top-left
    bool beyondNear = false;  ///< the whole sphere lies beyond the near plane, which therefore clips nothing of it
    double pixelReach = 0.0;  ///< upper bound, in map units, on how far a point moves when it moves by one pixel
};

/// The view of an instance. The relation is never Outside for a sphere that intersects the frustum (margin: geometry/frustum.h,
/// conservativeMargin). `frame`: of the mesh's maps. `record`, if it is not null, is told of the
/// sphere's tests where they fall, and then of the relation; `line`: of the strategy's listing.
[[nodiscard]] ObjectSpaceView objectSpaceView(const Scene& scene, uint32_t instance, const MapFrame& frame, const View& view,
                                              ObjectRecord* record = nullptr, uint8_t line = 0);
/// The same of a sphere around the mesh, relative to its origin, in the mesh's own coordinates.
[[nodiscard]] inline ObjectSpaceView objectSpaceView(const Scene& scene, uint32_t instance, const Sphere& sphere,
                                                     const View& view, ObjectRecord* record = nullptr, uint8_t line = 0) {
    return objectSpaceView(scene, instance, MapFrame{sphere}, view, record, line);
}

}  // namespace cullscope::spherical
