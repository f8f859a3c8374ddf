#pragma once

#include <QPainter>

#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// Paints over a picture of a model in spherical coordinates what its ticks mean in degrees, which colours stand for which R,
/// and, where the strategy submitted a part of the object only, that this is all that is drawn. Units as in PictureExtras.
void paintModelScales(QPainter& painter, const QRectF& target, const ViewPicture& picture, double unit);

}  // namespace cullscope::ui
