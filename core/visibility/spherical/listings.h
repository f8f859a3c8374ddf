#pragma once

#include "core/visibility/show.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The lines of the listings of the strategies that decide by cells of maps. `spherical` has all of them; `spherical-horizon` has
/// Whole and Slopes from Whole on.
enum class BandsLine : uint8_t { Objects = 1, Sphere, Outside, Whole, Rays, Cells, Region, Boxes, Bands, Draw, Slopes = Rays };
/// The line at which `spherical` drew of an object that is not outside, and at which `spherical-horizon` did.
[[nodiscard]] BandsLine lineOfBands(const SphericalDecision& decision);
[[nodiscard]] BandsLine lineOfHorizon(const SphericalDecision& decision);
[[nodiscard]] Show bandsListing();
[[nodiscard]] Show horizonListing();

/// The lines of the listing of `spherical-lossless`.
enum class WalkLine : uint8_t { Groups = 1, GroupOutside, Objects, Sphere, Walk, Planes, Cones, Horizon, Draw, Triangles };
/// The line at which the walk ended at a cell, by the cause for which it was culled; none: it is drawn.
[[nodiscard]] WalkLine lineOfCell(const std::optional<Cause>& cause);
[[nodiscard]] Show walkListing();

/// A strategy's other shows with its listing behind them.
[[nodiscard]] std::vector<Show> withListing(std::vector<Show> shows, Show listing);

}  // namespace cullscope::spherical
