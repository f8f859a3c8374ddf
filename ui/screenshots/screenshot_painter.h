#pragma once

#include "core/image/picture_file.h"
#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// Paints the whole screenshot from its pictures, one per part: headlines, wipes, marks, legend and caption. Straight alpha, four
/// bytes a pixel. May run on any thread. Throws Error(Usage) if there is not enough memory.
[[nodiscard]] QImage paintScreenshot(const ScreenshotPlan& plan, const std::vector<TiledPicture::Result>& pictures);

/// The painted screenshot as written to a file: with metadata, and with depths and triangle numbers if they were requested.
[[nodiscard]] Picture screenshotPicture(const ScreenshotPlan& plan, std::vector<TiledPicture::Result> pictures);

}  // namespace cullscope::ui
