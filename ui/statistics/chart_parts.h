#pragma once

#include <QCategoryAxis>
#include <QChart>
#include <QFont>
#include <QPainter>
#include <QValueAxis>
#include <QXYSeries>
#include <functional>
#include <memory>

#include "ui/statistics/plot_colours.h"
#include "ui/statistics/plot_legend.h"
#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

/// What the plots made with Qt Charts have in common.

/// A chart without title, ground and legend, to which series and axes are added.
[[nodiscard]] std::unique_ptr<QChart> bareChart(const PlotColours& colours);

/// Adds an axis in the plots' colours and type, without a title, which Qt Charts would cut in a low chart; the chart owns it.
void addAxis(QChart& chart, QAbstractAxis* axis, Qt::Alignment side, const QFont& font, const PlotColours& colours);
/// Writes what a chart shows at the top of its place, in several lines where it must, and gives what is left.
[[nodiscard]] QRectF takeCaption(QPainter& painter, const QRectF& place, const QString& caption, const PlotColours& colours);
/// Adds a series and ties it to all axes that the chart has by then; the chart owns it.
void addSeries(QChart& chart, QXYSeries* series);

/// Adds a straight line that stands for no strategy.
void addRule(QChart& chart, const QPointF& from, const QPointF& to, const QPen& pen);

/// An axis from 0 to at least `most` with round numbers and few ticks.
[[nodiscard]] QValueAxis* axisFromZero(double most);
/// An axis over `count` numbered poses, ticks at round numbers that stand apart in a width in pixels.
[[nodiscard]] QValueAxis* poseAxis(size_t count, double width);

/// Where a chart's values stand on what it is painted on.
using PlaceOf = std::function<QPointF(const QPointF& value)>;

/// Paints a chart in a place, as vectors; then calls `over`, if any, for what belongs over it.
void paintChart(QPainter& painter, const QRectF& place, std::unique_ptr<QChart> chart,
                const std::function<void(const PlaceOf& placeOf)>& over = {});

/// How each run is drawn: its colour and line; the baselines grey.
[[nodiscard]] std::vector<PlotLegend::Entry> runStyles(const std::vector<RunFigures>& runs, const PlotColours& colours);

}  // namespace cullscope::ui
