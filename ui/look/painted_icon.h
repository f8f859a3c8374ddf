#pragma once

#include <QIcon>
#include <QPainter>
#include <functional>

namespace cullscope::ui {

/// An icon that is drawn anew whenever it is shown, so that it follows the application's palette. `draw` gets the place of the
/// icon within its margins.
[[nodiscard]] QIcon paintedIcon(std::function<void(QPainter& painter, const QRectF& place)> draw, double margin);

}  // namespace cullscope::ui
