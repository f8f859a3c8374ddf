#pragma once

#include "core/experiments/stability/battery.h"

namespace cullscope::stability {

/// Every strategy of the registry that this OpenGL can run, at its defaults, at each other choice that it declares, one
/// parameter at a time, and at the least value of a number where its promise for the scene is stronger there.
[[nodiscard]] std::vector<StrategyRequest> everyStrategy(const ScenePointer& scene, const GlInfo& gl);

/// Draws the case's scene from its cameras with every strategy, and counts the pixels that are lost (measure/accuracy.h).
[[nodiscard]] Findings everyStrategyOnTheScene(const Bench& bench, const StabilityCase& which);

/// The same of some strategies. One that promises to be exact or conservative at a view must lose nothing there.
[[nodiscard]] Findings onTheScene(const Bench& bench, const StabilityCase& which, const ScenePointer& scene,
                                  const std::vector<StrategyRequest>& strategies);

}  // namespace cullscope::stability
