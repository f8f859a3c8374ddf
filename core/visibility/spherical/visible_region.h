#pragma once

#include <span>

#include "core/visibility/object_record.h"
#include "core/visibility/spherical/decision.h"
#include "core/visibility/spherical/object_space_view.h"
#include "core/visibility/spherical/readings.h"

namespace cullscope::spherical {

/// Follows one corner ray as in Han & Hong 2008, Appendix 1: its entry into the bounding sphere or box, the walk through the
/// index map, and the confirmed triangle. The region's corner is the hit. Without a hit it is the ray's entry, or where it has
/// none the point of the sphere or box nearest to it. `number`: of the corner. `record`, if it is not null, is told of the entry
/// and of every cell where they fall, and then of what was found.
[[nodiscard]] CornerRay followCorner(const SphericalMaps& maps, const Ray& ray, uint32_t number, RayStart start,
                                     ObjectRecord* record);

enum class Pole { None, North, South };

/// The pole whose direction is within the view: the outermost point of the surface on the polar axis, or the centre where the
/// axis meets no surface, lies inside the frustum, and the eye lies beyond its horizontal plane. At most one of them does.
[[nodiscard]] Pole poleInView(const SphericalMaps& maps, const ObjectSpaceView& view);

/// Visibility_Area_Test of Appendix 1: the region between corners (one at least) and the boxes around its smallest and largest θ
/// and φ, extended by the cells of the hit triangles' centroids. The case is 1 where a pole lies in it (full rows from that pole
/// on), 3 where its azimuths cross the seam, else 2. `pole`: the one in view; nullopt: that around which the outline winds.
[[nodiscard]] VisibleRegion visibleRegion(const SphericalMaps& maps, std::span<const CornerRay> corners, Join join,
                                          std::optional<Pole> pole);

/// The cells of a region's boxes in runs: one run in case 1, one for each row in case 2, two for each row in case 3.
[[nodiscard]] std::vector<CellRun> runsOf(const SphericalGrid& grid, const VisibleRegion& region);

}  // namespace cullscope::spherical
