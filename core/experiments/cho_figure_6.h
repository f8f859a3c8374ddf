#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// Figure 6 of Cho et al., "A View-Frustum Culling Technique Using OpenGL for Large Polygon Models": 400 bunnies from 40
/// viewpoints, direct rendering beside view-frustum culling, with the numbers that the paper's text states.
[[nodiscard]] Experiment choFigure6();

}  // namespace cullscope
