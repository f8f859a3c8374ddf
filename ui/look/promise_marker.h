#pragma once

#include <QColor>
#include <QPainter>
#include <QRectF>

#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// Draws the marker of a promise: a disc (exact set), a square (lossless) or a triangle (lossy).
void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QColor& colour);

/// Draws the same marker with an outline.
void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QPen& outline, const QBrush& fill);

}  // namespace cullscope::ui
