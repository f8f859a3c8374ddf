#include "ui/look/promise_marker.h"

#include <QPolygonF>

namespace cullscope::ui {

void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QColor& colour) {
    drawPromiseMarker(painter, place, promise, QPen(Qt::NoPen), QBrush(colour));
}

void drawPromiseMarker(QPainter& painter, const QRectF& place, Promise promise, const QPen& outline, const QBrush& fill) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(outline);
    painter.setBrush(fill);
    switch (promise) {
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
