#pragma once

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"
#include "core/visibility/parameters.h"

namespace cullscope {

/// The parameter `facing = two-sided | front | auto` that every strategy has whose facing rule is not fixed. `two-sided` is the
/// default of those that reproduce a paper which draws both sides.
[[nodiscard]] ParameterDeclaration facingParameter(std::string defaultId = "auto");

/// The rule for a scene: `auto` is front where every mesh is closed and consistently oriented, two-sided elsewhere. Two-sided
/// also for strategies without the parameter.
[[nodiscard]] Facing resolveFacing(const ParameterSet& parameters, const Scene& scene);

}  // namespace cullscope
