#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/scene/camera.h"

namespace cullscope::ui {

/// The options of a screenshot.
struct ScreenshotOptions {
    enum class Background { AsShown, White, Black, Transparent };

    std::optional<Viewport> size;  ///< of the whole picture, in pixels; none: as in the window
    bool grid = false;             ///< all shown views in their arrangement; false: one view
    bool overlays = true;  ///< frustum, boxes, what strategies declare, wipe and marks; in a grid also a headline over each
                           ///< view
    bool legend = true;    ///< the meaning of the colours, with counts
    bool caption = true;   ///< a line with scene, strategy and metrics
    QString captionText;   ///< text of the caption; empty: made from scene, strategy and metrics
    Background background = Background::AsShown;

    bool operator==(const ScreenshotOptions&) const = default;
};

/// The options as one JSON object, for settings and for a picture's metadata.
[[nodiscard]] std::string optionsText(const ScreenshotOptions& options);
/// Reads such an object; missing or invalid values keep their defaults.
[[nodiscard]] ScreenshotOptions screenshotOptionsFromText(std::string_view text);

}  // namespace cullscope::ui
