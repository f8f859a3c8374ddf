#pragma once

#include <filesystem>

#include "ui/screenshots/screenshot_options.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// The options and files of screenshots, stored from the last one.
struct ScreenshotSettings {
    ScreenshotOptions options;
    QString folder;
    QString pattern;  ///< file name template for core's nextFileName; its extension determines the format

    /// The settings of the last screenshot; at first PNG files in the user's picture folder.
    [[nodiscard]] static ScreenshotSettings load();
    void save() const;
};

/// The file of the next screenshot of `session`. Throws Error(Usage) with one sentence if it cannot be written: unknown
/// field or extension, missing folder, or a folder without write permission.
[[nodiscard]] std::filesystem::path screenshotPath(const Session& session, const ScreenshotSettings& settings);

}  // namespace cullscope::ui
