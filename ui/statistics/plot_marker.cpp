#include "ui/statistics/plot_marker.h"

#include <QPolygonF>

namespace cullscope::ui {

void drawPlotMarker(QPainter& painter, const QRectF& place, const PlotMarker& marker) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(marker.outline);
    painter.setBrush(marker.fill);
    switch (marker.promise) {
        case Promise::Exact:
            painter.drawEllipse(place);
            break;
        case Promise::Conservative:
            painter.drawRect(place.adjusted(0.5, 0.5, -0.5, -0.5));
            break;
        case Promise::Approximate:
            painter.drawPolygon(QPolygonF({QPointF(place.center().x(), place.top()), place.bottomRight(), place.bottomLeft()}));
            break;
    }
    painter.restore();
}

}  // namespace cullscope::ui
