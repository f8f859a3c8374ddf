#pragma once

#include <QPainter>

#include "ui/session/session.h"
#include "ui/views/picture_layout.h"

namespace cullscope::ui {

/// Marks the pick over a picture: the outline of the triangle, a ring around a triangle too small to be seen, and the box of the
/// object if the scene has several. Drawn on top of the picture, so that hidden and culled objects are marked too.
void paintPick(QPainter& painter, const Scene& opened, const Pick& pick, const View& viewing, const PictureLayout& layout);

}  // namespace cullscope::ui
