#pragma once

#include <QPainter>
#include <QString>
#include <optional>
#include <vector>

#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// A word over a picture.
struct PlacedName {
    QString text;
    QPointF place;    ///< on what it names where that is seen, in picture pixels from the top left; the word stands there
    QRectF extent{};  ///< of what is seen of it: above one that is smaller than the word, the word stands over it
};

/// The overlays of a picture, in the units of the painter.
struct PictureExtras {
    Wipe wipe;
    QString left, right;               ///< labels of the two sides of the wipe's line
    std::optional<QPointF> loupe;      ///< its centre, in picture pixels from the top left
    std::optional<QRectF> markedLoss;  ///< in picture pixels from the top left
    std::vector<PlacedName> names{};   ///< of objects
    bool modelScales = false;          ///< degrees and colour scale of a model in spherical coordinates
    double unit = 1.0;                 ///< scale of line widths and of the loupe: 1 in a window, more in a large screenshot
};

/// Paints the image of a picture into a rectangle so that its pixels stay crisp: reduced with the mean of what falls together,
/// enlarged with even squares whose edges alone are mixed.
void paintScaled(QPainter& painter, const QRectF& target, const QImage& image);

/// Paints a picture into a rectangle, with wipe, loupe, marked loss and scales; used for the window and for screenshots. Text is
/// in the painter's font.
void paintPicture(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras);

/// Paints the names alone, of which paintPicture paints those in its extras.
void paintNames(QPainter& painter, const QRectF& target, const ViewPicture& picture, const PictureExtras& extras);

}  // namespace cullscope::ui
