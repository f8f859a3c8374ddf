#pragma once

#include "core/frame/frame_context.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// In a scene of more objects the tests of an object's rays, bands and cells are not recorded, only their results: they would
/// take hundreds of megabytes.
inline constexpr size_t kMostWithTests = 64;

/// Says the search along the four corner rays, one decision each, then the region between their corners; nothing for an object
/// that was not decided by rays.
void recordRays(const SphericalDecision& decision, FrameContext& frame);

/// Says the tests of the contour bands, sector by sector from the near point on; nothing for an object that was not decided by
/// bands. `line`: of the strategy's listing.
void recordBands(const SphericalDecision& decision, uint8_t line, FrameContext& frame);

}  // namespace cullscope::spherical
