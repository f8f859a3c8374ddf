#pragma once

#include <QPainter>

#include "ui/jobs/view_picture.h"

namespace cullscope::ui {

/// Paints over a picture of a model in spherical coordinates: degrees at the ticks, the colour scale of R, and a note if the
/// strategy submitted only a part of the object. Units as in PictureExtras.
void paintModelScales(QPainter& painter, const QRectF& target, const ViewPicture& picture, double unit);

}  // namespace cullscope::ui
