#pragma once

#include "core/image/picture_file.h"
#include "ui/screenshots/screenshot_plan.h"

namespace cullscope::ui {

/// The whole screenshot from its pictures, one a part: headlines, wipes, marks, legend and caption. Straight alpha, four bytes a
/// pixel. On any thread. Throws Error(Usage) where there is no memory for it.
[[nodiscard]] QImage paintScreenshot(const ScreenshotPlan& plan, const std::vector<TiledPicture::Result>& pictures);

/// The same as a file holds it, with metadata, and with depth and triangles where they were wanted.
[[nodiscard]] Picture screenshotPicture(const ScreenshotPlan& plan, std::vector<TiledPicture::Result> pictures);

}  // namespace cullscope::ui
