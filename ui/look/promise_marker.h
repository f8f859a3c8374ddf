#pragma once

#include <QColor>
#include <QPainter>
#include <QRectF>

#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// Draws the shape that stands for a promise: a disc (exact set), a square (lossless), a triangle (lossy).
void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QColor& colour);

/// The same shape with an outline.
void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QPen& outline, const QBrush& fill);

}  // namespace cullscope::ui
