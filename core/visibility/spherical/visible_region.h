#pragma once

#include <span>

#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// Follows one corner ray as in Han & Hong 2008, Appendix 1: where it enters the bounding sphere, the walk through the index map,
/// the confirmed triangle. The region's corner is the hit; where nothing is hit, the sphere's point nearest to the ray (the
/// entry, where the ray enters it; the paper is silent).
[[nodiscard]] CornerRay followCorner(const SphericalMaps& maps, const Ray& ray, bool keepWalkedCells);

/// How the region's corners are joined; the paper says only that they are.
enum class Join {
    Chart,  ///< by straight lines on the θ–φ map: the extremes lie at the corners
    Arcs    ///< by great circles: a box reaches to an arc's extreme latitude
};

/// Visibility_Area_Test of Appendix 1: the region between four corners and the boxes around its smallest and largest θ and φ,
/// with the cells of the confirmed triangles' centroids in them. The case: 1 where the outline winds around a pole (full rows
/// from that pole on), 3 where its azimuths cross the seam, else 2.
[[nodiscard]] VisibleRegion visibleRegion(const SphericalMaps& maps, std::span<const CornerRay, 4> corners, Join join);

/// The cells of a region's boxes in runs: one; one a row; two a row.
[[nodiscard]] std::vector<CellRun> runsOf(const SphericalGrid& grid, const VisibleRegion& region);

}  // namespace cullscope::spherical
