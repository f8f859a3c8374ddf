#pragma once

#include <array>
#include <optional>

#include "core/visibility/overlay.h"
#include "core/visibility/spherical/decision.h"
#include "core/visibility/spherical/map_overlays.h"

/// Lines over the pictures of Figures 5 to 8 of Han & Hong 2008.
namespace cullscope::han_hong {

/// The corners of a scene's triangle in world coordinates.
[[nodiscard]] std::array<Vec3, 3> cornersInWorld(const Scene& scene, uint64_t triangle);

/// How light an object is shown at a place (relative to the map's centre): every other band is darker, the second, fourth, …
[[nodiscard]] double lightnessOfBand(const spherical::ContourBands& bands, const Vec3& place);

/// The rim of what a frame draws: the edges of which only one triangle is drawn.
[[nodiscard]] OverlayLines rimOf(const OverlayContext& context, const FrameLog& log);

/// How the largest S of a sector comes about, in world coordinates: R from the origin to its place on the surface, projected on
/// the axis perpendicular to the sight ray.
struct Projection {
    Vec3 origin{0.0}, place{0.0};
    Vec3 start{0.0};            ///< of the sight ray in the bounding sphere: its point nearest to the eye
    Vec3 top{0.0};              ///< the end of the perpendicular axis
    Vec3 onPerpendicular{0.0};  ///< S from the origin on that axis
    std::vector<Vec3> arc;      ///< α, from the sight ray to R
    double radius = 0.0;        ///< of the bounding sphere
};
/// Of the largest S that is not hidden for good by a nearer band; none where there is no S. The map must have bands by S.
[[nodiscard]] std::optional<Projection> projectionOf(const Scene& scene, const spherical::MapSnapshot& map,
                                                     const std::vector<spherical::SizePlace>& sizes);
/// The origin, the perpendicular axis with S on it, R, α, and the projection in dashes.
[[nodiscard]] std::vector<OverlayLines> projectionLines(const OverlayContext& context, const Projection& projection);
/// The colour of R and its projection.
[[nodiscard]] Vec3f projectionColour();

}  // namespace cullscope::han_hong
