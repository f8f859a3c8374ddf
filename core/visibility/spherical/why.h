#pragma once

#include "core/visibility/spherical/decision.h"
#include "core/visibility/why.h"

namespace cullscope::spherical {

/// Appends the steps of a spherical strategy's decision about a triangle (numbered within its mesh): the object's relation to the
/// frustum, the triangle's cell, and why that cell is drawn or not.
void addMapSteps(const MapSnapshot& map, uint32_t triangle, std::vector<WhyStep>& steps);

}  // namespace cullscope::spherical
