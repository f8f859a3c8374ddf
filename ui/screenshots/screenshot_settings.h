#pragma once

#include <filesystem>

#include "ui/screenshots/screenshot_options.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Screenshots as they were taken the last time: what they are like and where they go.
struct ScreenshotSettings {
    ScreenshotOptions options;
    QString folder;
    QString pattern;  ///< as core's nextFileName takes it; its ending chooses the format

    /// Of the last time; the first time PNG files in the user's folder for pictures.
    [[nodiscard]] static ScreenshotSettings load();
    void save() const;
};

/// The file that a screenshot of what `session` shows would be. Throws Error(Usage) with one sentence where it cannot be written:
/// an unknown field or ending, no such folder, or one that is not the user's to write in.
[[nodiscard]] std::filesystem::path screenshotPath(const Session& session, const ScreenshotSettings& settings);

}  // namespace cullscope::ui
