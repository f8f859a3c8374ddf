#pragma once

#include <QBrush>
#include <QPainter>
#include <QPen>
#include <QRectF>

#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// How a strategy's point looks in a plot and in its legend: its shape is the promise, as in drawPromiseMarker.
struct PlotMarker {
    Promise promise = Promise::Approximate;
    QBrush fill;  ///< Qt::NoBrush: an outline that stands for the shape alone
    QPen outline;
};

void drawPlotMarker(QPainter& painter, const QRectF& place, const PlotMarker& marker);

}  // namespace cullscope::ui
