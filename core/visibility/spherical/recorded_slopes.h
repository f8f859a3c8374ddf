#pragma once

#include "core/frame/frame_context.h"
#include "core/visibility/spherical/contour_bands.h"

namespace cullscope::spherical {

/// Says the slopes of an object's bands from the near point on, which are no tests yet, then the test of each of its cells
/// against them; nothing for an object that was not decided by slopes.
void recordSlopes(const SphericalMaps& maps, const BandCells& cells, const SphericalDecision& decision, FrameContext& frame);

}  // namespace cullscope::spherical
