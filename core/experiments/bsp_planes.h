#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// Depth, polygons and build time of BSP trees by the choice of the dividing plane.
[[nodiscard]] Experiment bspPlanes();

}  // namespace cullscope
