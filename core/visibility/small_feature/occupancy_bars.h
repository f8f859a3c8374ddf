#pragma once

#include <span>

#include "core/frame/frame_log.h"
#include "core/visibility/bars.h"
#include "core/visibility/show.h"

namespace cullscope::small_feature {

/// The show of the histogram below.
[[nodiscard]] Show occupancyBarsShow();

/// The number of components by occupancy value, in classes that a power of two of `split` divides: the classes of the outline and
/// of the details are apart. A class of which the recorded frame left out the most for their size is coloured so. `values`: by
/// instance.
[[nodiscard]] Bars occupancyBars(std::span<const double> values, double split, const Scene& scene, const FrameLog& log);

}  // namespace cullscope::small_feature
