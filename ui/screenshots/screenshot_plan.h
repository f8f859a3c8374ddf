#pragma once

#include <QFont>
#include <QRect>
#include <functional>
#include <vector>

#include "core/image/picture_metadata.h"
#include "ui/screenshots/screenshot_options.h"
#include "ui/session/session.h"
#include "ui/jobs/tiled_picture.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

/// A colour of the pictures and what it means.
struct LegendEntry {
    std::optional<TriangleState> state;  ///< none: a mark of `colour`
    QColor colour;                       ///< transparent: words without a mark, the heading of the counts
    QString words;
    QRect place;  ///< in the screenshot, swatch and words together
};
/// An entry's words, with the count where there is one.
[[nodiscard]] QString legendText(const LegendEntry& entry, const std::optional<uint64_t>& count);

/// Everything that a screenshot is made from, fixed at one moment: what the window shows afterwards changes nothing of it.
struct ScreenshotPlan {
    struct Part {
        int view = 0;
        QRect picture;   ///< where its picture lies, in pixels from the top left
        QRect headline;  ///< above it; empty: none
        QString words;   ///< of the headline
        ViewRequest request;
        TiledPicture::Wanted wanted;
        PictureExtras extras;
        bool overlays = true;
        PictureSubject subject;
    };
    Viewport size;
    double unit = 1.0;  ///< pixels of what is one pixel wide on a screen
    QFont font;
    DrawStyle style;
    std::vector<Part> parts;  ///< one, or all shown views
    std::vector<LegendEntry> legend;
    int legendPart = -1;  ///< of which part the counts are; -1: of none
    QRect captionPlace;
    QString caption;
    PictureMetadata metadata;
};

/// What is painted over a view's picture in the window (SceneView::extras).
using ExtrasOf = std::function<PictureExtras(int view)>;

/// The plan for what `session` shows now, of the active view or of all. Throws Error(Usage) with one sentence where there is
/// nothing to show yet, or no place for it in the size that is asked for. `keepsDepth`: the file takes depth and triangles.
[[nodiscard]] ScreenshotPlan planScreenshot(Session& session, const ScreenshotOptions& options, const ExtrasOf& extras,
                                            bool keepsDepth);

}  // namespace cullscope::ui
