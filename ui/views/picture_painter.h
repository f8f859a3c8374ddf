#pragma once

#include <QPainter>
#include <QString>
#include <optional>

#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// What is painted over a picture, in the units of the painter.
struct PictureExtras {
    Wipe wipe;
    QString left, right;               ///< what lies on either side of the wipe's line
    std::optional<QPointF> loupe;      ///< its middle, in pixels of the picture from the top left
    std::optional<QRectF> markedLoss;  ///< in pixels of the picture from the top left
    bool modelScales = false;          ///< degrees and colours, of a model in spherical coordinates
    double unit = 1.0;                 ///< size of a line and of the loupe: 1 in a window, more in a large screenshot
};

/// Paints a picture into a rectangle, with its wipe, its loupe, the marked loss and scales; the same in the window and in
/// screenshots. Lettering takes the painter's font.
void paintPicture(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras);

}  // namespace cullscope::ui
