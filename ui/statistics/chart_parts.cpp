#include "ui/statistics/chart_parts.h"

#include <QGraphicsLayout>
#include <QGraphicsScene>
#include <QLineSeries>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr double kTickWidth = 44.0;  // least pixels between two numbered poses

/// 1, 2 or 5 times a power of ten, at least `least`.
double roundStep(double least) {
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
    return 10.0 * power;
}

}  // namespace

std::unique_ptr<QChart> bareChart(const PlotColours& colours) {
    auto chart = std::make_unique<QChart>();
    chart->setBackgroundVisible(false);
    chart->setPlotAreaBackgroundVisible(false);
    chart->legend()->hide();
    chart->setMargins(QMargins(2, 2, 2, 2));
    chart->layout()->setContentsMargins(0, 0, 0, 0);
    chart->setDropShadowEnabled(false);
    chart->setPalette(QPalette(colours.ground));
    return chart;
}

void addAxis(QChart& chart, QAbstractAxis* axis, Qt::Alignment side, const QFont& font, const PlotColours& colours) {
    chart.addAxis(axis, side);
    axis->setLabelsFont(font);
    axis->setLabelsBrush(colours.text);
    axis->setLabelsColor(colours.text);
    axis->setGridLinePen(QPen(colours.grid, 1.0));
    axis->setLinePen(QPen(colours.faintText, 1.0));
    axis->setShadesVisible(false);
    axis->setTruncateLabels(false);
}

QRectF takeCaption(QPainter& painter, const QRectF& place, const QString& caption, const PlotColours& colours) {
    const QRectF wanted =
        painter.fontMetrics().boundingRect(QRect(0, 0, int(place.width()), int(place.height())), Qt::TextWordWrap, caption);
    painter.setPen(colours.text);
    painter.drawText(QRectF(place.topLeft(), QSizeF(place.width(), wanted.height())), Qt::TextWordWrap, caption);
    return place.adjusted(0.0, wanted.height(), 0.0, 0.0);
}

void addSeries(QChart& chart, QXYSeries* series) {
    chart.addSeries(series);
    for (QAbstractAxis* axis : chart.axes()) series->attachAxis(axis);
}

void addRule(QChart& chart, const QPointF& from, const QPointF& to, const QPen& pen) {
    auto* line = new QLineSeries;
    line->append(from);
    line->append(to);
    line->setPen(pen);
    addSeries(chart, line);
}

QValueAxis* axisFromZero(double most) {
    auto* axis = new QValueAxis;
    const double step = roundStep(std::max(most, 1e-6) / 4.0);
    const int steps = std::max(1, int(std::ceil(most / step - 1e-9)));
    axis->setRange(0.0, step * steps);
    axis->setTickCount(steps + 1);
    const int digits = std::max(0, -int(std::floor(std::log10(step) + 1e-9)));
    axis->setLabelFormat(QStringLiteral("%.%1f").arg(digits));
    return axis;
}

QValueAxis* poseAxis(size_t count, double width) {
    auto* axis = new QValueAxis;
    const double last = count > 1 ? double(count - 1) : 1.0;
    axis->setRange(0.0, last);
    axis->setTickType(QValueAxis::TicksDynamic);
    axis->setTickAnchor(0.0);
    axis->setTickInterval(std::max(1.0, roundStep(last * kTickWidth / std::max(kTickWidth, width))));
    axis->setLabelFormat(QStringLiteral("%.0f"));
    return axis;
}

void paintChart(QPainter& painter, const QRectF& place, std::unique_ptr<QChart> chart,
                const std::function<void(const PlaceOf& placeOf)>& over) {
    QGraphicsScene scene;
    chart->resize(place.size());
    chart->layout()->activate();
    QChart* shown = chart.release();
    scene.addItem(shown);
    scene.render(&painter, place, QRectF(QPointF(0.0, 0.0), place.size()), Qt::IgnoreAspectRatio);
    if (over) over([&](const QPointF& value) { return shown->mapToPosition(value) + place.topLeft(); });
}

std::vector<PlotLegend::Entry> runStyles(const std::vector<RunFigures>& runs, const PlotColours& colours) {
    std::vector<PlotLegend::Entry> styles;
    size_t number = 0;
    for (const RunFigures& run : runs) {
        if (run.id == QLatin1String("all"))
            styles.push_back({run.label, colours.faintText, Qt::DotLine, {}});
        else if (run.baseline())
            styles.push_back({run.label, colours.faintText, Qt::DashLine, {}});
        else
            styles.push_back({run.label, colours.series(number++), Qt::SolidLine, {}});
    }
    return styles;
}

}  // namespace cullscope::ui
