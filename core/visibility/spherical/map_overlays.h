#pragma once

#include <vector>

#include "core/visibility/overlay.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The tests of strategies with maps of directions, for every object that is not outside the frustum: the bounding sphere as
/// three great circles; where the frustum cuts it, the visible region on the sphere (dashed) with its boxes, and the corner rays
/// from the eye, with a ring where they enter the sphere, to a dot at their hit, or to a cross at the region's corner for a ray
/// that misses (Han & Hong 2008, Figure 3). For `spherical-lossless` the borders of the tested cells on the near side of the
/// sphere, coloured by verdict, if they are some pixels large.
[[nodiscard]] std::vector<OverlayLines> sphereOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps);

/// The contour bands on the bounding spheres: the circles between them, coloured by the verdict of the sectors of the band
/// beyond; the circle at 90° with a wider line; the axis with its start (ring) and end (dot); and on both sides of the axis each
/// band's S, drawn from the axis outward (Han & Hong 2008, Figures 5 and 6). For `spherical-horizon`, which has slopes, the
/// height of the sight line there. Circles closer than a few pixels are left out.
[[nodiscard]] std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps);

/// Whether the map has a kernel that can be drawn.
[[nodiscard]] inline bool hasKernel(const MapSnapshot& map) {
    return map.kernel && map.kernel->filled() && map.decision.relation != SphereRelation::Outside;
}
/// The inner kernels of the objects that are not outside the frustum, without those of a few pixels: the grid of a kernel's map
/// on its surface, on the side that faces the viewing camera and as dense as pixels allow; its outline as seen from the culling
/// camera's eye, where the horizon was used; and the axis from the centre (dot) to that eye.
[[nodiscard]] std::vector<OverlayLines> kernelOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps);

}  // namespace cullscope::spherical
