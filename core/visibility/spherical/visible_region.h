#pragma once

#include <span>

#include "core/visibility/spherical/decision.h"
#include "core/visibility/spherical/object_record.h"

namespace cullscope::spherical {

/// Follows one corner ray as in Han & Hong 2008, Appendix 1: its entry into the bounding sphere, the walk through the index map,
/// and the confirmed triangle. The region's corner is the hit. Without a hit it is the sphere's point nearest to the ray (its
/// entry point, if it enters the sphere); the paper does not define this case. `number`: of the corner. `record`, if it is not
/// null, is told of the entry and of every cell where they fall, and then of what was found.
[[nodiscard]] CornerRay followCorner(const SphericalMaps& maps, const Ray& ray, uint32_t number, ObjectRecord* record);

/// How the region's corners are connected, which the paper does not specify.
enum class Join {
    Chart,  ///< by straight lines on the θ–φ map: the extremes are at the corners
    Arcs    ///< by great-circle arcs: a box extends to an arc's extreme latitude
};

/// Visibility_Area_Test of Appendix 1: the region between four corners and the boxes around its smallest and largest θ and φ,
/// extended by the cells of the hit triangles' centroids. The case is 1 where the outline winds around a pole (full rows from
/// that pole on), 3 where its azimuths cross the seam, else 2.
[[nodiscard]] VisibleRegion visibleRegion(const SphericalMaps& maps, std::span<const CornerRay, 4> corners, Join join);

/// The cells of a region's boxes in runs: one run in case 1, one for each row in case 2, two for each row in case 3.
[[nodiscard]] std::vector<CellRun> runsOf(const SphericalGrid& grid, const VisibleRegion& region);

}  // namespace cullscope::spherical
