#pragma once

#include "core/experiments/experiment.h"

namespace cullscope::han_hong {

/// What the sizes in Table 1 of Han & Hong 2008 can be made of: layouts of the model and of each map, in bytes of the scene's
/// first mesh, beside the paper's numbers in units of 1,000,000 and of 1,048,576 bytes.
[[nodiscard]] Experiment tableLayouts();

}  // namespace cullscope::han_hong
