#pragma once

#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Height in pixels of a picture with text of normal size; text grows with the height.
inline constexpr double kUnitHeight = 720.0;

/// Sets a plan's size, its font and the rectangles of pictures, headlines, legend and caption. The requests of the parts are
/// still those of the screen. `largestCount` is the widest number that the legend has to hold. Throws Error(Usage) if a part does
/// not fit.
void layOut(ScreenshotPlan& plan, const ScreenshotOptions& options, uint64_t largestCount);

}  // namespace cullscope::ui
