#pragma once

#include <QColor>
#include <QPainter>
#include <QString>
#include <vector>

namespace cullscope::ui {

/// Words that stand at points of a plot.
struct PointLabel {
    QPointF point;
    QString words;
};

/// Where the words stand: above or below their points or a little to the side of that, inside `bounds` where there is room, and
/// over no other words or point, of which each takes `marker` pixels in both directions.
[[nodiscard]] std::vector<QRectF> placeLabels(const std::vector<PointLabel>& labels, const QFontMetricsF& metrics,
                                              const QRectF& bounds, double marker);

/// Writes them; a line leads from words to a point that is not next to them.
void paintLabels(QPainter& painter, const std::vector<PointLabel>& labels, const QRectF& bounds, double marker,
                 const QColor& colour);

}  // namespace cullscope::ui
