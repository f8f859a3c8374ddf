#pragma once

#include <optional>
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

/// The colours of those great circles and of the visible region: red and dashed, as in the paper's Figure 4.
[[nodiscard]] Vec3f sphereColour(const Vec3f& background);
[[nodiscard]] Vec3f regionColour(const Vec3f& background);

/// The contour bands on the bounding spheres: the circles between them, coloured by the verdict of the sectors of the band
/// beyond; the circle at 90° with a wider line; and the axis with its start (ring) and end (dot) (Han & Hong 2008, Figure 5).
/// Circles closer than a few pixels are left out.
[[nodiscard]] std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps);

/// S of each band in one sector, that in which the profile is best visible: from the axis, perpendicular to it, to the direction
/// and distance of the cell that has the band's S, so that it begins at the foot of the surface that it is measured at (Han &
/// Hong 2008, Figure 6); dashed where the band is hidden, and in the colour of what is wrongly culled where it is hidden for good
/// by a nearer band although its own S is larger. The largest other one is labelled with the letter S, and a dashed level on from
/// it shows what it hides. The axis has its start (ring) and end (dot); thin lines enclose the sector and divide it into bands.
/// For `spherical-horizon`, which has slopes, the heights of the sight lines with that slope. `sector`: shown in place of that.
[[nodiscard]] std::vector<OverlayLines> sizeOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps,
                                                    const std::optional<uint32_t>& sector = {});
/// The colour of S, which no verdict has.
[[nodiscard]] Vec3f sizeColour(const Vec3f& background);

/// S of a band's sector with the place that it is measured at, in the map's coordinates.
struct SizePlace {
    uint32_t band = 0;
    double size = 0.0;  ///< S
    Vec3 foot{0.0};     ///< on the axis
    Vec3 surface{0.0};  ///< at R of the cell's farthest centroid, in the direction of the cell's middle
    bool drawn = true;
    bool larger = false;  ///< not drawn, because a nearer band was hidden, although its S is larger than all before it
};
/// Of all bands of a sector that have an S, from near to far. The map must have bands by S.
[[nodiscard]] std::vector<SizePlace> sizePlaces(const MapSnapshot& map, uint32_t sector);
/// The sector of a map's bands that sizeOverlay shows.
[[nodiscard]] uint32_t shownSector(const OverlayContext& context, const MapSnapshot& map);

/// Whether the map has a kernel that can be drawn.
[[nodiscard]] inline bool hasKernel(const MapSnapshot& map) {
    return map.kernel && map.kernel->filled() && map.decision.relation != SphereRelation::Outside;
}
/// The inner kernels of the objects that are not outside the frustum, without those of a few pixels: the grid of a kernel's map
/// on its surface, on the side that faces the viewing camera and as dense as pixels allow; its outline as seen from the culling
/// camera's eye, where the horizon was used; and the axis from the centre (dot) to that eye.
[[nodiscard]] std::vector<OverlayLines> kernelOverlay(const OverlayContext& context, const std::vector<MapSnapshot>& maps);

}  // namespace cullscope::spherical
