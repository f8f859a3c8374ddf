#pragma once

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"
#include "core/visibility/parameters.h"

namespace cullscope {

/// The parameter `facing = two-sided | front | auto` of every strategy without a fixed facing rule. `two-sided` is the default of
/// strategies from papers that draw both sides.
[[nodiscard]] ParameterDeclaration facingParameter(std::string defaultId = "auto");

/// The facing rule for a scene: `auto` is front for each object whose mesh is closed, consistently oriented and outward, and
/// two-sided for the others. Two-sided for strategies without the parameter.
/// Front where that is the rule of every object, TwoSided where it is that of none, else ByObject.
[[nodiscard]] Facing facingByObject(const Scene& scene);
[[nodiscard]] Facing resolveFacing(const ParameterSet& parameters, const Scene& scene);

}  // namespace cullscope
