#pragma once

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"
#include "core/visibility/parameters.h"

namespace cullscope {

/// The parameter `facing = two-sided | front | auto` of every strategy without a fixed facing rule. `two-sided` is the default of
/// strategies from papers that draw both sides.
[[nodiscard]] ParameterDeclaration facingParameter(std::string defaultId = "auto");

/// The facing rule for a scene: `auto` is front where every mesh is closed, consistently oriented and outward, else two-sided.
/// Two-sided for strategies without the parameter.
[[nodiscard]] Facing resolveFacing(const ParameterSet& parameters, const Scene& scene);

}  // namespace cullscope
