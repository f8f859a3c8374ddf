#pragma once

#include <QFont>
#include <QRect>
#include <functional>
#include <vector>

#include "core/image/picture_metadata.h"
#include "ui/jobs/tiled_picture.h"
#include "ui/screenshots/screenshot_options.h"
#include "ui/session/session.h"
#include "ui/views/picture_painter.h"

namespace cullscope::ui {

/// A colour in the pictures and its meaning.
struct LegendEntry {
    std::optional<TriangleState> state;  ///< none: a mark in `colour`
    QColor colour;                       ///< transparent: text without a mark, the heading of the counts
    QString words;
    QRect place;  ///< of mark and text together, in the screenshot
};
/// The text of an entry, with its count if there is one.
[[nodiscard]] QString legendText(const LegendEntry& entry, const std::optional<uint64_t>& count);

/// All inputs of a screenshot, captured at one moment: later changes in the window do not affect it.
struct ScreenshotPlan {
    struct Part {
        int view = 0;
        QRect picture;   ///< rectangle of the picture, in pixels from the top left
        QRect headline;  ///< rectangle above the picture; empty: no headline
        QString words;   ///< text of the headline
        ViewRequest request;
        TiledPicture::Wanted wanted;
        PictureExtras extras;
        bool overlays = true;
        PictureSubject subject;
    };
    Viewport size;
    double unit = 1.0;  ///< pixels that correspond to one pixel on a screen
    QFont font;
    DrawStyle style;
    std::vector<Part> parts;  ///< one view, or all shown views
    std::vector<LegendEntry> legend;
    /// The legend's counts: the view's figures, of the size that the caption states; none: there are no counts.
    std::optional<std::array<uint64_t, kTriangleStateCount>> counts;
    QRect captionPlace;
    QString caption;
    PictureMetadata metadata;
};

/// Returns the overlays of a view's picture in the window (SceneView::extras).
using ExtrasOf = std::function<PictureExtras(int view)>;

/// The plan of a screenshot of the present state of `session`: of the active view or of all shown views. `keepsDepth`: the file
/// format stores depth and triangle numbers. Throws Error(Usage) with one sentence if there is no picture yet, or if the
/// requested size has no room for it.
[[nodiscard]] ScreenshotPlan planScreenshot(Session& session, const ScreenshotOptions& options, const ExtrasOf& extras,
                                            bool keepsDepth);

}  // namespace cullscope::ui
