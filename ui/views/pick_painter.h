#pragma once

#include <QPainter>

#include "ui/session/session.h"
#include "ui/views/picture_layout.h"

namespace cullscope::ui {

/// Marks what is picked over a picture: the triangle's outline, a ring around one too small to be seen, and the object's box
/// where the scene has several. Drawn over everything: what is hidden or was left out has its place, too.
void paintPick(QPainter& painter, const Scene& opened, const Pick& pick, const View& viewing, const PictureLayout& layout);

}  // namespace cullscope::ui
