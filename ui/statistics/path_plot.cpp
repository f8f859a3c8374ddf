#include "ui/statistics/path_plot.h"

#include <QLineSeries>
#include <algorithm>
#include <cmath>

#include "ui/statistics/chart_parts.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kPathMargin = 4.0;
constexpr double kBesideFrom = 560.0;
constexpr int kLeastPathChart = 120;
constexpr size_t kMostDots = 60;

}  // namespace

PathPlot::PathPlot(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void PathPlot::setRuns(std::vector<RunFigures> runs, size_t poseCount) {
    m_runs = std::move(runs);
    m_poseCount = poseCount;
    contentsChanged();
}

QString PathPlot::title() const { return tr("Along the path"); }

bool PathPlot::lossKnown() const {
    return std::any_of(m_runs.begin(), m_runs.end(),
                       [](const RunFigures& run) { return run.poses.front().missedPpm.has_value(); });
}

QString PathPlot::description() const {
    QStringList lines;
    for (const RunFigures& run : m_runs)
        lines << tr("%1: %2 a frame on average").arg(run.label, millisecondsText(run.frameMilliseconds));
    return lines.join(QLatin1Char('\n'));
}

int PathPlot::neededHeight(int width) const {
    const PlotLegend legend(runStyles(m_runs, PlotColours(palette())), QFontMetricsF(font()));
    const int charts = lossKnown() && width < kBesideFrom ? 2 : 1;
    return int(std::ceil(legend.heightWith(charts * kLeastPathChart, width - 2 * kPathMargin) + 2 * kPathMargin));
}

void PathPlot::paintFigure(QPainter& painter, const QRectF& place, const PlotColours& colours, Figure figure) const {
    std::unique_ptr<QChart> chart = bareChart(colours);
    const auto value = [figure](const PoseFigures& pose) {
        return figure == Figure::Time ? pose.frameMilliseconds : double(pose.missedPixels);
    };
    double most = figure == Figure::Time ? 0.0 : 1.0;
    for (const RunFigures& run : m_runs)
        for (const PoseFigures& pose : run.poses) most = std::max(most, value(pose));
    addAxis(*chart, poseAxis(m_poseCount, place.width()), Qt::AlignBottom, painter.font(), colours);
    addAxis(*chart, axisFromZero(most), Qt::AlignLeft, painter.font(), colours);
    const std::vector<PlotLegend::Entry> styles = runStyles(m_runs, colours);
    for (size_t i = 0; i < m_runs.size(); ++i) {
        auto* line = new QLineSeries;
        for (const PoseFigures& pose : m_runs[i].poses) line->append(double(pose.pose), value(pose));
        line->setPen(QPen(styles[i].colour, 2.0, styles[i].line));
        line->setPointsVisible(m_poseCount <= kMostDots);
        addSeries(*chart, line);
    }
    const QString caption = figure == Figure::Time ? tr("Frame time in ms, by pose") : tr("Missed pixels, by pose");
    paintChart(painter, takeCaption(painter, place, caption, colours), std::move(chart));
}

void PathPlot::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    PlotLegend legend(runStyles(m_runs, colours), QFontMetricsF(painter.font()));
    const QRectF inner = legend.takeFrom(place.adjusted(kPathMargin, kPathMargin, -kPathMargin, -kPathMargin));
    if (!lossKnown()) {
        paintFigure(painter, inner, colours, Figure::Time);
    } else {
        const bool beside = place.width() >= kBesideFrom;
        const QSizeF half = beside ? QSizeF(inner.width() / 2, inner.height()) : QSizeF(inner.width(), inner.height() / 2);
        const QPointF second = beside ? QPointF(half.width(), 0.0) : QPointF(0.0, half.height());
        paintFigure(painter, {inner.topLeft(), half}, colours, Figure::Time);
        paintFigure(painter, {inner.topLeft() + second, half}, colours, Figure::Missed);
    }
    legend.paint(painter, colours);
}

}  // namespace cullscope::ui
