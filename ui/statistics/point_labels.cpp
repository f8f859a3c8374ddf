#include "ui/statistics/point_labels.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr double kLabelGap = 2.0;
constexpr int kMostRows = 8;  // that words may be away from their point
// How far to the side, pixels, that they may be moved.
constexpr std::array kAside{0.0, 14.0, -14.0, 28.0, -28.0, 42.0, -42.0};

/// Words so many rows above the point, below where negative, and so many pixels aside; moved sideways into the bounds.
QRectF placeAt(const QPointF& point, const QSizeF& size, int row, double aside, const QRectF& bounds, double marker) {
    const double away = marker / 2 + kLabelGap + (std::abs(row) - 1) * size.height();
    const double top = row > 0 ? point.y() - away - size.height() : point.y() + away;
    const double left = std::max(bounds.left(), std::min(point.x() + aside - size.width() / 2, bounds.right() - size.width()));
    return {QPointF(left, top), size};
}

}  // namespace

std::vector<QRectF> placeLabels(const std::vector<PointLabel>& labels, const QFontMetricsF& metrics, const QRectF& bounds,
                                double marker) {
    std::vector<QRectF> taken;
    for (const PointLabel& label : labels) taken.emplace_back(label.point - QPointF(marker, marker) / 2, QSizeF(marker, marker));
    std::vector<QRectF> places;
    for (const PointLabel& label : labels) {
        const QSizeF size(metrics.horizontalAdvance(label.words) + kLabelGap, metrics.height());
        const auto isFree = [&](const QRectF& place) {
            return place.top() >= bounds.top() && place.bottom() <= bounds.bottom() &&
                   std::none_of(taken.begin(), taken.end(), [&](const QRectF& other) { return other.intersects(place); });
        };
        const auto freePlace = [&] {
            for (int distance = 1; distance <= kMostRows; ++distance)
                for (const double aside : kAside)
                    for (const int row : {distance, -distance})
                        if (const QRectF place = placeAt(label.point, size, row, aside, bounds, marker); isFree(place))
                            return place;
            return placeAt(label.point, size, 1, 0.0, bounds, marker);
        };
        const QRectF place = freePlace();
        taken.push_back(place);
        places.push_back(place);
    }
    return places;
}

void paintLabels(QPainter& painter, const std::vector<PointLabel>& labels, const QRectF& bounds, double marker,
                 const QColor& colour) {
    const std::vector<QRectF> places = placeLabels(labels, QFontMetricsF(painter.font()), bounds, marker);
    for (size_t i = 0; i < labels.size(); ++i) {
        const QPointF& point = labels[i].point;
        const QPointF nearest(std::clamp(point.x(), places[i].left(), places[i].right()),
                              point.y() > places[i].center().y() ? places[i].bottom() : places[i].top());
        if (std::hypot(nearest.x() - point.x(), nearest.y() - point.y()) > marker) {
            painter.setPen(QPen(colour, 0.6));
            painter.drawLine(point, nearest);
        }
        painter.setPen(colour);
        painter.drawText(places[i], Qt::AlignCenter, labels[i].words);
    }
}

}  // namespace cullscope::ui
