#pragma once

#include <QIcon>
#include <QPainter>
#include <functional>

namespace cullscope::ui {

/// An icon that is painted anew whenever it is shown, so that it follows the application's palette. `draw` receives the icon's
/// rectangle without its margins.
[[nodiscard]] QIcon paintedIcon(std::function<void(QPainter& painter, const QRectF& place)> draw, double margin);

}  // namespace cullscope::ui
