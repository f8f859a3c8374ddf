#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// What a screenshot is to be like.
struct ScreenshotOptions {
    enum class Background { AsShown, White, Black, Transparent };

    std::optional<Viewport> size;  ///< of the file's picture, in pixels; none: as in the window
    bool grid = false;             ///< all shown views as they are arranged; false: one view
    bool overlays = true;          ///< frustum, boxes, bands, kernel, wipe and marks, and a line about each view of a grid
    bool legend = true;            ///< what the colours mean, with counts
    bool caption = true;           ///< a line about scene, strategy and figures
    QString captionText;           ///< in its place; empty: made from scene, strategy and figures
    Background background = Background::AsShown;

    bool operator==(const ScreenshotOptions&) const = default;
};

/// One JSON object, for settings and for a picture's metadata.
[[nodiscard]] std::string optionsText(const ScreenshotOptions& options);
/// What is missing or wrong keeps its default.
[[nodiscard]] ScreenshotOptions screenshotOptionsFromText(std::string_view text);

}  // namespace cullscope::ui
