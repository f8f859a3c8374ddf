#pragma once

#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Lettering has its usual size in a picture of this height, and grows with it.
inline constexpr double kUnitHeight = 720.0;

/// Gives a plan its size, its fonts and the places of pictures, headlines, legend and caption. The parts' requests are those of
/// the screen; `largestCount` is the widest number that the legend has to hold. Throws Error(Usage) where something has no place.
void layOut(ScreenshotPlan& plan, const ScreenshotOptions& options, uint64_t largestCount);

}  // namespace cullscope::ui
