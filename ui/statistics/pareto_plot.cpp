#include "ui/statistics/pareto_plot.h"

#include <QAreaSeries>
#include <QLineSeries>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/statistics/chart_parts.h"
#include "ui/statistics/point_labels.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kParetoMargin = 4.0;
constexpr int kLeastParetoChart = 130;
constexpr double kMarkerSize = 11.0;

/// How a run's point looks; the baselines, both grey, are a dark and a light one.
PlotMarker markerOf(const RunFigures& run, const QColor& colour, const PlotColours& colours) {
    const QColor grey = run.id == QLatin1String("all") ? colours.baselineCull : colours.ground;
    return {run.promise, run.baseline() ? grey : colour, QPen(colours.text, 1.2)};
}

/// The axis of speeds: every run's interval and 1 in it.
QValueAxis* speedAxis(const std::vector<RunFigures>& runs) {
    double most = 1.0;
    for (const RunFigures& run : runs) most = std::max({most, run.speedup, run.speedupCi95[1]});
    return axisFromZero(most * 1.02);
}

QCategoryAxis* lossAxis(int lowest, int highest, const QString& zero) {
    auto* axis = new QCategoryAxis;
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    axis->setRange(lowest - 1.5, highest + 0.2);
    axis->setStartValue(lowest - 1.5);
    // Qt Charts reads labels as HTML.
    axis->append(zero.toHtmlEscaped(), lowest - 1.0);
    // Few labels on many decades: they stand in as little as 100 pixels.
    const int step = highest - lowest > 3 ? 2 : 1;
    for (int decade = lowest; decade <= highest; decade += step)
        axis->append(QLocale().toString(std::pow(10.0, decade), 'f', std::max(0, -decade)), decade);
    return axis;
}

/// The band on which nothing missed stands.
void addZeroBand(QChart& chart, double from, double to, double width, const PlotColours& colours) {
    auto* lower = new QLineSeries;
    auto* upper = new QLineSeries;
    for (const double x : {0.0, width}) {
        lower->append(x, from);
        upper->append(x, to);
    }
    auto* band = new QAreaSeries(upper, lower);
    lower->setParent(band);
    upper->setParent(band);
    band->setPen(Qt::NoPen);
    band->setBrush(colours.grid);
    chart.addSeries(band);
    for (QAbstractAxis* axis : chart.axes()) band->attachAxis(axis);
}

}  // namespace

ParetoPlot::ParetoPlot(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void ParetoPlot::setRuns(const std::vector<RunFigures>& runs) {
    m_runs.clear();
    std::copy_if(runs.begin(), runs.end(), std::back_inserter(m_runs),
                 [](const RunFigures& run) { return run.missedPpm.has_value(); });
    m_lossUnknown = m_runs.empty() && !runs.empty();
    m_fronts = runFronts(m_runs);
    contentsChanged();
}

QString ParetoPlot::title() const { return tr("Speed against loss"); }

QString ParetoPlot::emptySentence() const {
    return m_lossUnknown ? tr("The missed pixels were not measured, so there is no loss to show.") : PlotWidget::emptySentence();
}

QString ParetoPlot::description() const {
    QStringList lines;
    for (const RunFigures& run : m_runs)
        lines << tr("%1, %2: ×%3 against backface, %4 per million missed")
                     .arg(run.label, promiseWord(run.promise), ratioText(run.speedup),
                          *run.missedPpm > 0.0 ? ppmText(*run.missedPpm) : zeroLabel());
    return lines.join(QLatin1Char('\n'));
}

int ParetoPlot::lowestDecade() const {
    int lowest = 0;
    for (const RunFigures& run : m_runs)
        if (*run.missedPpm > 0.0) lowest = std::min(lowest, int(std::floor(std::log10(*run.missedPpm))));
    return lowest;
}

int ParetoPlot::highestDecade() const {
    int highest = 3;
    for (const RunFigures& run : m_runs)
        if (*run.missedPpm > 0.0) highest = std::max(highest, int(std::ceil(std::log10(*run.missedPpm))));
    return highest;
}

double ParetoPlot::height(double missedPpm) const { return missedPpm > 0.0 ? std::log10(missedPpm) : lowestDecade() - 1.0; }

QString ParetoPlot::zeroLabel() const {
    size_t views = 0;
    for (const RunFigures& run : m_runs) views = std::max(views, run.poses.size());
    //: Nothing missed in %1 views: with 95 % confidence, the share of views that lose something is below 3/%1.
    return tr("0 (< 3/%1)").arg(views);
}

const RunFront* ParetoPlot::frontOf(size_t run) const {
    const auto found = std::find_if(m_fronts.begin(), m_fronts.end(), [&](const RunFront& front) {
        return std::find(front.runs.begin(), front.runs.end(), run) != front.runs.end();
    });
    return found == m_fronts.end() ? nullptr : &*found;
}

QString ParetoPlot::shortLabel(size_t run) const {
    QStringList values;
    for (const RunFront& front : m_fronts)
        for (size_t i = 0; i < front.runs.size(); ++i)
            if (front.runs[i] == run) values << front.values[qsizetype(i)];
    if (!values.isEmpty()) return values.join(QStringLiteral(" · "));
    // Ids are shorter; they do where they tell the runs apart.
    const auto same =
        std::count_if(m_runs.begin(), m_runs.end(), [&](const RunFigures& other) { return other.id == m_runs[run].id; });
    return same > 1 ? m_runs[run].label : m_runs[run].id;
}

std::vector<QColor> ParetoPlot::runColours(const PlotColours& colours) const {
    std::vector<QColor> ofRuns;
    size_t single = m_fronts.size();
    for (size_t run = 0; run < m_runs.size(); ++run) {
        const RunFront* front = frontOf(run);
        if (front)
            ofRuns.push_back(colours.series(size_t(front - m_fronts.data())));
        else
            ofRuns.push_back(m_runs[run].baseline() ? colours.faintText : colours.series(single++));
    }
    return ofRuns;
}

void ParetoPlot::addFronts(QChart& chart, const PlotColours& colours) const {
    for (size_t number = 0; number < m_fronts.size(); ++number) {
        auto* line = new QLineSeries;
        line->setPen(QPen(colours.series(number), 1.4));
        for (const size_t run : m_fronts[number].runs) line->append(m_runs[run].speedup, height(*m_runs[run].missedPpm));
        addSeries(chart, line);
    }
}

PlotLegend ParetoPlot::legend(const PlotColours& colours, const QFont& font) const {
    std::vector<PlotLegend::Entry> entries;
    const std::vector<QColor> ofRuns = runColours(colours);
    for (size_t i = 0; i < m_runs.size(); ++i)
        if (!frontOf(i)) entries.push_back({m_runs[i].label, ofRuns[i], Qt::SolidLine, markerOf(m_runs[i], ofRuns[i], colours)});
    for (size_t i = 0; i < m_fronts.size(); ++i)
        entries.push_back({frontName(m_fronts[i].id, m_fronts[i].key), colours.series(i), Qt::SolidLine, {}});
    for (const Promise promise : {Promise::Exact, Promise::Conservative, Promise::Approximate})
        if (std::any_of(m_runs.begin(), m_runs.end(), [&](const RunFigures& run) { return run.promise == promise; }))
            entries.push_back({tr("shape: %1").arg(promiseWord(promise)), colours.faintText, Qt::SolidLine,
                               PlotMarker{promise, Qt::NoBrush, QPen(colours.faintText, 1.2, Qt::DotLine)}});
    return {std::move(entries), QFontMetricsF(font)};
}

int ParetoPlot::neededHeight(int width) const {
    const PlotLegend words = legend(PlotColours(palette()), font());
    return int(std::ceil(words.heightWith(kLeastParetoChart, width - 2 * kParetoMargin) + 2 * kParetoMargin));
}

void ParetoPlot::paintPoints(QPainter& painter, const QRectF& bounds, const PlotColours& colours, const PlaceOf& placeOf) const {
    const std::vector<QColor> ofRuns = runColours(colours);
    std::vector<PointLabel> labels;
    for (size_t i = 0; i < m_runs.size(); ++i) {
        const QPointF centre = placeOf({m_runs[i].speedup, height(*m_runs[i].missedPpm)});
        const QRectF place(centre - QPointF(kMarkerSize, kMarkerSize) / 2, QSizeF(kMarkerSize, kMarkerSize));
        drawPlotMarker(painter, place, markerOf(m_runs[i], ofRuns[i], colours));
        labels.push_back({centre, shortLabel(i)});
    }
    paintLabels(painter, labels, bounds, kMarkerSize, colours.text);
}

void ParetoPlot::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    PlotLegend words = legend(colours, painter.font());
    const QRectF inner = words.takeFrom(place.adjusted(kParetoMargin, kParetoMargin, -kParetoMargin, -kParetoMargin));
    std::unique_ptr<QChart> chart = bareChart(colours);
    QValueAxis* speeds = speedAxis(m_runs);
    addAxis(*chart, speeds, Qt::AlignBottom, painter.font(), colours);
    const int lowest = lowestDecade();
    addAxis(*chart, lossAxis(lowest, highestDecade(), zeroLabel()), Qt::AlignLeft, painter.font(), colours);
    addZeroBand(*chart, lowest - 1.5, lowest - 0.5, speeds->max(), colours);
    addRule(*chart, {1.0, lowest - 1.5}, {1.0, highestDecade() + 0.2}, QPen(colours.faintText, 1.0, Qt::DashLine));
    addFronts(*chart, colours);
    const std::vector<QColor> ofRuns = runColours(colours);
    for (size_t i = 0; i < m_runs.size(); ++i) {
        const double y = height(*m_runs[i].missedPpm);
        const auto [least, most] = m_runs[i].speedupCi95;
        // Paler than the fronts, which run the same way where nothing is missed.
        QColor pale = ofRuns[i];
        pale.setAlphaF(0.5F);
        addRule(*chart, {least, y}, {most, y}, QPen(pale, 1.5));
    }
    const QString caption = tr("Upwards: missed per million; to the right: speed against backface");
    const QRectF chartPlace = takeCaption(painter, inner, caption, colours);
    paintChart(painter, chartPlace, std::move(chart),
               [&](const PlaceOf& placeOf) { paintPoints(painter, chartPlace, colours, placeOf); });
    words.paint(painter, colours);
}

}  // namespace cullscope::ui
