#include "ui/statistics/sphere_map.h"

#include <algorithm>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr double kMapMargin = 8.0;
constexpr double kLeastHeight = 90.0;
constexpr double kLeastRadius = 4.0;
constexpr double kLargestRadius = 8.0;
constexpr double kReach = 12.0;  // how far from a dot a click still counts

}  // namespace

QString SphereMap::subject() const { return tr("Loss by direction of view"); }

int SphereMap::neededHeight(int /*width*/) const { return int(kLeastHeight + 3.0 * QFontMetricsF(font()).height()); }

QRectF SphereMap::map(const QFontMetricsF& metrics, const QRectF& place) const {
    const double left = metrics.horizontalAdvance(QStringLiteral("−90°")) + 6.0;
    const QRectF inner = place.adjusted(kMapMargin + left, kMapMargin, -kMapMargin - left / 2, -kMapMargin - metrics.height());
    const double legend = inner.width() > 560.0 ? 170.0 : 0.0;
    const double width = std::min(inner.width() - legend, 3.0 * inner.height());
    const double height = std::min(inner.height(), width / 2.0);
    return {inner.left(), inner.top(), width, height};
}

QPointF SphereMap::dot(const QRectF& map, const PoseFigures& pose) {
    return {map.left() + (pose.azimuth + 180.0) / 360.0 * map.width(),
            map.top() + (90.0 - pose.elevation) / 180.0 * map.height()};
}

int SphereMap::poseAt(const QPointF& place) const {
    const QRectF area = map(QFontMetricsF(font()), belowTitle(QFontMetricsF(font()), rect()));
    int nearest = -1;
    double least = kReach;
    for (size_t i = 0; i < run().poses.size(); ++i) {
        const QPointF offset = dot(area, run().poses[i]) - place;
        const double distance = std::hypot(offset.x(), offset.y());
        if (distance > least) continue;
        least = distance;
        nearest = int(i);
    }
    return nearest;
}

void SphereMap::paintAxes(QPainter& painter, const QRectF& area, const PlotColours& colours) const {
    const QFontMetricsF metrics(painter.font());
    const double line = metrics.height();
    const auto degrees = [](int value) {
        return (value < 0 ? QStringLiteral("−") : QString()) + QString::number(std::abs(value)) + QStringLiteral("°");
    };
    for (int azimuth = -180; azimuth <= 180; azimuth += 90) {
        const double x = area.left() + (azimuth + 180.0) / 360.0 * area.width();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(colours.faintText);
        painter.drawText(QRectF(x - 30.0, area.bottom() + 1.0, 60.0, line), Qt::AlignCenter, degrees(azimuth));
    }
    for (int elevation = -90; elevation <= 90; elevation += 90) {
        const double y = area.top() + (90.0 - elevation) / 180.0 * area.height();
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
        painter.setPen(colours.faintText);
        painter.drawText(QRectF(area.left() - 66.0, y - line / 2, 60.0, line), Qt::AlignRight | Qt::AlignVCenter,
                         degrees(elevation));
    }
}

void SphereMap::paintDot(QPainter& painter, const QPointF& place, const std::optional<double>& missedPpm,
                         const PlotColours& colours) {
    const double share = missedPpm ? lossShare(*missedPpm) : 0.0;
    const bool loses = share > 0.0;
    const double radius = kLeastRadius + (kLargestRadius - kLeastRadius) * share;
    painter.setPen(QPen(loses ? colours.ground : colours.noLoss, loses ? 1.0 : 1.6));
    painter.setBrush(loses ? QBrush(colours.loss) : QBrush(Qt::NoBrush));
    painter.drawEllipse(place, radius, radius);
}

void SphereMap::paintLegend(QPainter& painter, const QRectF& place, const PlotColours& colours) const {
    const double line = QFontMetricsF(painter.font()).height();
    QPointF at(place.left() + kLargestRadius, place.top() + line / 2);
    for (const auto& [ppm, words] : {std::pair(0.0, tr("nothing missed")), std::pair(10.0, tr("%1 per million").arg(10)),
                                     std::pair(1000.0, tr("%1 per million").arg(1000)), std::pair(1e5, tr("a tenth"))}) {
        paintDot(painter, at, ppm, colours);
        painter.setPen(colours.text);
        painter.drawText(QPointF(at.x() + kLargestRadius + 6.0, at.y() + QFontMetricsF(painter.font()).ascent() / 2 - 1.0),
                         words);
        at.ry() += line + 5.0;
    }
}

void SphereMap::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    paintTitle(painter, place, colours);
    const QRectF area = map(metrics, belowTitle(metrics, place));
    paintAxes(painter, area, colours);
    const QRectF legend(area.right() + 30.0, area.top(), place.right() - area.right() - 30.0, area.height());
    if (legend.width() > 150.0) paintLegend(painter, legend, colours);
    // The worst last, so that nothing lies over it.
    std::vector<size_t> order(run().poses.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](size_t a, size_t b) { return run().poses[a].missedPixels < run().poses[b].missedPixels; });
    for (const size_t i : order) {
        const QPointF centre = dot(area, run().poses[i]);
        paintDot(painter, centre, run().poses[i].missedPpm, colours);
        if (int(i) != current()) continue;
        painter.setPen(QPen(colours.chosen, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, kReach - 1.0, kReach - 1.0);
    }
}

}  // namespace cullscope::ui
