#include "ui/statistics/pose_strip.h"

#include <algorithm>
#include <cmath>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kStripMargin = 10.0;
constexpr double kLossHeight = 34.0;
constexpr double kLeastTimes = 40.0;
constexpr double kWidestColumn = 40.0;
constexpr double kSharpFrom = 4.0;

}  // namespace

QString PoseStrip::subject() const { return tr("Time and loss by pose"); }

int PoseStrip::neededHeight(int /*width*/) const {
    return int(kLeastTimes + kLossHeight + 3.0 * QFontMetricsF(font()).height() + 2.0 * kStripMargin);
}

double PoseStrip::longestFrame() const {
    double longest = 0.0;
    for (const PoseFigures& pose : run().poses) longest = std::max(longest, pose.frameMilliseconds);
    return longest;
}

PoseStrip::Areas PoseStrip::areas(const QFontMetricsF& metrics, const QRectF& place) const {
    const QString longest = millisecondsText(longestFrame());
    const double labels = std::max({metrics.horizontalAdvance(tr("frame")), metrics.horizontalAdvance(tr("missed")),
                                    metrics.horizontalAdvance(longest)}) +
                          6.0;
    const QRectF inner = place.adjusted(kStripMargin, kStripMargin / 2, -kStripMargin, -kStripMargin / 2);
    const double bottom = inner.bottom() - metrics.height();
    Areas areas;
    const double most = kWidestColumn * double(std::max<size_t>(1, poseCount()));
    const double width = std::min(inner.width() - labels, most);
    areas.losses = {inner.left() + labels, bottom - kLossHeight, width, kLossHeight};
    areas.times = {areas.losses.left(), inner.top(), width, areas.losses.top() - 2.0 - inner.top()};
    areas.labels = {inner.left(), inner.top(), labels - 6.0, bottom - inner.top()};
    areas.numbers = {areas.losses.left(), bottom, inner.width() - labels, metrics.height()};
    return areas;
}

QRectF PoseStrip::column(const QRectF& area, size_t pose) const {
    const double width = area.width() / double(poseCount());
    const double left = area.left() + width * double(pose);
    if (width < kSharpFrom) return {left, area.top(), std::max(1.0, width), area.height()};
    // On whole pixels, so that the gaps are equally wide.
    return {std::round(left), area.top(), std::round(left + width) - std::round(left) - 1.0, area.height()};
}

int PoseStrip::poseAt(const QPointF& place) const {
    const Areas parts = areas(QFontMetricsF(font()), belowTitle(QFontMetricsF(font()), rect()));
    const QRectF both = parts.times.united(parts.losses);
    if (!both.contains(place)) return -1;
    const auto pose = size_t((place.x() - both.left()) / both.width() * double(poseCount()));
    const auto found = std::find_if(run().poses.begin(), run().poses.end(), [&](const PoseFigures& p) { return p.pose == pose; });
    return found == run().poses.end() ? -1 : int(found - run().poses.begin());
}

void PoseStrip::paintLabels(QPainter& painter, const Areas& parts, const PlotColours& colours) const {
    painter.setPen(colours.grid);
    painter.drawLine(parts.times.topLeft(), parts.times.topRight());
    painter.drawLine(parts.losses.topLeft(), parts.losses.topRight());
    painter.setPen(colours.text);
    const double line = QFontMetricsF(painter.font()).height();
    const QRectF& labels = parts.labels;
    painter.drawText(QRectF(labels.left(), parts.times.top(), labels.width(), line), Qt::AlignRight,
                     millisecondsText(longestFrame()));
    painter.drawText(QRectF(labels.left(), parts.times.bottom() - line, labels.width(), line), Qt::AlignRight, tr("frame"));
    painter.drawText(QRectF(labels.left(), parts.losses.top(), labels.width(), line), Qt::AlignRight, tr("missed"));
}

void PoseStrip::paintNumbers(QPainter& painter, const Areas& parts, const PlotColours& colours) const {
    const QFontMetricsF metrics(painter.font());
    const double room = metrics.horizontalAdvance(QString::number(poseCount())) + 8.0;
    const double width = parts.times.width() / double(poseCount());
    const auto step = size_t(std::max(1.0, std::ceil(room / width)));
    painter.setPen(colours.faintText);
    for (size_t pose = 0; pose < poseCount(); pose += step) {
        const double x = parts.times.left() + width * (double(pose) + 0.5);
        painter.drawText(QRectF(x - room / 2, parts.numbers.top(), room, parts.numbers.height()), Qt::AlignCenter,
                         QString::number(pose));
    }
}

void PoseStrip::paintLoss(QPainter& painter, const QRectF& column, const PoseFigures& pose, const PlotColours& colours) const {
    if (!pose.missedPpm) return;
    if (pose.missedPixels == 0) {
        // Nothing missed is a ring of its own, not a short bar.
        const double side = std::min(6.0, column.width());
        painter.setPen(QPen(colours.noLoss, 1.2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(QRectF(column.center().x() - side / 2, column.top() + 4.0, side, side));
        return;
    }
    painter.fillRect(QRectF(column.left(), column.top() + 1.0, column.width(), lossShare(*pose.missedPpm) * column.height()),
                     colours.loss);
}

void PoseStrip::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    paintTitle(painter, place, colours);
    const Areas parts = areas(metrics, belowTitle(metrics, place));
    paintLabels(painter, parts, colours);
    paintNumbers(painter, parts, colours);
    const double longest = longestFrame();
    for (size_t i = 0; i < run().poses.size(); ++i) {
        const PoseFigures& pose = run().poses[i];
        QRectF bar = column(parts.times, pose.pose);
        bar.setTop(bar.bottom() - pose.frameMilliseconds / longest * bar.height());
        painter.fillRect(bar, colours.draw);
        paintLoss(painter, column(parts.losses, pose.pose), pose, colours);
        if (int(i) != current()) continue;
        painter.setPen(QPen(colours.chosen, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(column(parts.times.united(parts.losses), pose.pose));
    }
}

}  // namespace cullscope::ui
