#pragma once

#include "core/image/page.h"
#include "core/visibility/overlay.h"
#include "core/visibility/spherical/decision.h"

/// Lines over the pictures of the figures of Han & Hong 2008 that the strategy's own overlays do not have.
namespace cullscope::han_hong {

/// Share of the way to the eye by which lines on a surface stand before it, and a place moved so.
inline constexpr double kRaised = 0.003;
[[nodiscard]] Vec3 raised(const OverlayContext& context, const Vec3& place);

/// The search of Figure 3: corner rays, pale where a surface hides them, with their entries and hits; and the visible region and
/// its boxes, which are angles, on the outermost surface of the object in these directions. The map must have a region.
[[nodiscard]] std::vector<OverlayLines> searchOnSurface(const OverlayContext& context, const spherical::MapSnapshot& map);

/// The bounding sphere of an object as three great circles.
[[nodiscard]] OverlayLines greatCircles(const OverlayContext& context, const spherical::MapSnapshot& map);

/// Where a place lies in a picture, in pixels from its upper left corner; none behind the viewing camera.
[[nodiscard]] std::optional<PlotPoint> placeIn(const View& viewing, const Vec3& place);

/// The sector in which S shows best what it is for: bands beyond 90° are drawn there and others hidden, each hidden one has an S
/// that is not larger than one before it, and of such sectors it is that nearest to `upright` (in the map's coordinates). Where
/// no sector is so, that with the fewest hidden bands of a larger S. The bands must not be slopes.
[[nodiscard]] uint32_t tellingSector(const spherical::ContourBands& bands, const Vec3& upright);

}  // namespace cullscope::han_hong
