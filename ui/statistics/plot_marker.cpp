#include "ui/statistics/plot_marker.h"

#include "ui/look/promise_marker.h"

namespace cullscope::ui {

void drawPlotMarker(QPainter& painter, const QRectF& place, const PlotMarker& marker) {
    drawPromiseMarker(painter, place, marker.promise, marker.outline, marker.fill);
}

}  // namespace cullscope::ui
