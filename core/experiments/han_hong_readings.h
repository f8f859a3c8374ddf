#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// What Han & Hong 2008 leave open, reading by reading: faces considered, corner rays that hit, speed and lost pixels of each.
[[nodiscard]] Experiment sphericalReadings();

/// Where the method works: over distances of 1.2 to 6 radii and fields of view of 10 to 90 degrees the corner rays that hit, the
/// share of the faces that is considered, the speed, and the share of the pixels that is lost.
[[nodiscard]] Experiment sphericalDomain();

}  // namespace cullscope
