#pragma once

#include "core/visibility/spherical/decision.h"
#include "core/visibility/why.h"

namespace cullscope::spherical {

/// Appends the steps of a spherical strategy's decision about a triangle (numbered within its mesh): the object's relation to the
/// frustum, the triangle's cell, and what `log` says of its region or band.
void addMapSteps(const MapSnapshot& map, const FrameLog& log, uint32_t triangle, std::vector<WhyStep>& steps);

}  // namespace cullscope::spherical
