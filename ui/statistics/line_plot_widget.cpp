#include "ui/statistics/line_plot_widget.h"

#include <QLineSeries>
#include <QLocale>
#include <cmath>

#include "ui/statistics/chart_parts.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

constexpr double kMargin = 4.0;
constexpr int kLeastChart = 130;
constexpr double kLabelGap = 6.0;
constexpr double kLeastTick = 44.0;   // pixels between two labels along x
constexpr double kTickLeading = 1.3;  // of a label's height, between two labels along y

/// What stands on the chart's plain axes: logarithms where a scale is logarithmic.
double onAxis(const PlotRange& range, double value) { return range.scale == PlotScale::Linear ? value : std::log10(value); }

QString numberText(double value) {
    const QString plain = QString::fromStdString(plotNumber(value));
    // Powers of ten far from 1 stay as core writes them.
    if (plain.contains(QLatin1Char('e'))) return plain;
    const qsizetype point = plain.indexOf(QLatin1Char('.'));
    return QLocale().toString(value, 'f', point < 0 ? 0 : int(plain.size() - point - 1));
}

/// As many of a range's round numbers as there is room for: on a logarithmic scale rather powers of ten alone.
std::vector<double> ticksOf(const PlotRange& range, size_t most) {
    std::vector<double> ticks = range.ticks;
    if (ticks.size() > most && range.scale == PlotScale::Logarithmic)
        std::erase_if(ticks, [](double tick) { return std::abs(std::log10(tick) - std::round(std::log10(tick))) > 1e-6; });
    const size_t step = (ticks.size() + most - 1) / most;
    std::vector<double> kept;
    for (size_t i = 0; i < ticks.size(); i += step) kept.push_back(ticks[i]);
    return kept;
}

/// An axis with a range's round numbers, as many as have `room` pixels of `length` each.
QCategoryAxis* axisOf(const PlotRange& range, double length, double room) {
    auto* axis = new QCategoryAxis;
    axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
    axis->setStartValue(onAxis(range, range.first));
    axis->setRange(onAxis(range, range.first), onAxis(range, range.last));
    for (const double tick : ticksOf(range, std::max<size_t>(2, size_t(length / room))))
        axis->append(numberText(tick), onAxis(range, tick));
    return axis;
}

QString referenceText(const PlotReference& reference) {
    return translated(reference.name) + QLatin1Char(' ') + numberText(reference.y);
}

QPen referencePen(const PlotColours& colours) { return {colours.faintText, 1.4, Qt::DotLine}; }

/// Each line with its colour.
std::vector<PlotLegend::Entry> stylesOf(const LinePlot& plot, const PlotColours& colours) {
    std::vector<PlotLegend::Entry> styles;
    for (size_t i = 0; i < plot.lines.size(); ++i) {
        const PlotLine& line = plot.lines[i];
        const QColor colour = line.baseline ? colours.faintText : colours.series(line.colour.value_or(i));
        styles.push_back({translated(line.name), colour, line.dashed ? Qt::DashLine : Qt::SolidLine, {}});
    }
    return styles;
}

void addLines(QChart& chart, const LinePlot& plot, const PlotRange& x, const PlotRange& y, const PlotColours& colours) {
    const std::vector<PlotLegend::Entry> styles = stylesOf(plot, colours);
    for (size_t i = 0; i < plot.lines.size(); ++i)
        for (const std::vector<PlotPoint>& piece : unbrokenPieces(plot.lines[i], x, y)) {
            auto* series = new QLineSeries;
            for (const PlotPoint& point : piece) series->append(onAxis(x, point.x), onAxis(y, point.y));
            series->setPen(QPen(styles[i].colour, 2.0, styles[i].line));
            // One point alone is no line.
            series->setPointsVisible(piece.size() == 1);
            addSeries(chart, series);
        }
}

}  // namespace

LinePlotWidget::LinePlotWidget(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void LinePlotWidget::setPlot(const LinePlot& plot) {
    m_plot = plot;
    contentsChanged();
}

QString LinePlotWidget::title() const { return translated(m_plot.title); }

QString LinePlotWidget::description() const {
    QStringList lines;
    for (const PlotLine& line : m_plot.lines) {
        QStringList numbers;
        for (const PlotPoint& point : line.points) numbers << QLocale().toString(point.y, 'g', 3);
        lines << QStringLiteral("%1: %2").arg(translated(line.name), numbers.join(QLatin1Char(' ')));
    }
    for (const PlotReference& reference : m_plot.references) lines << referenceText(reference);
    return lines.join(QLatin1Char('\n'));
}

PlotLegend LinePlotWidget::legend(const PlotColours& colours, const QFont& font) const {
    std::vector<PlotLegend::Entry> entries = stylesOf(m_plot, colours);
    for (const PlotReference& reference : m_plot.references)
        entries.push_back({referenceText(reference), referencePen(colours).color(), Qt::DotLine, {}});
    return {std::move(entries), QFontMetricsF(font)};
}

int LinePlotWidget::neededHeight(int width) const {
    const PlotLegend words = legend(PlotColours(palette()), font());
    return int(std::ceil(words.heightWith(kLeastChart, width - 2 * kMargin) + 2 * kMargin));
}

void LinePlotWidget::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    const QFontMetricsF metrics(painter.font());
    PlotLegend words = legend(colours, painter.font());
    const QRectF inner = words.takeFrom(place.adjusted(kMargin, kMargin, -kMargin, -kMargin));
    const QString caption = tr("Upwards: %1; to the right: %2").arg(translated(m_plot.y.title), translated(m_plot.x.title));
    // The numbers of the levels stand behind the chart, where no line hides them.
    double behind = 0.0;
    for (const PlotReference& reference : m_plot.references)
        behind = std::max(behind, metrics.horizontalAdvance(numberText(reference.y)) + kLabelGap);
    const QRectF chartPlace = takeCaption(painter, inner, caption, colours).adjusted(0.0, 0.0, -behind, 0.0);
    const PlotRange x = rangeAlongX(m_plot), y = rangeAlongY(m_plot);
    std::unique_ptr<QChart> chart = bareChart(colours);
    // Half of the last label of each axis stands beyond it.
    const QMargins margins = chart->margins();
    chart->setMargins({margins.left(), int(metrics.height() / 2), int(metrics.horizontalAdvance(numberText(x.last)) / 2) + 2,
                       margins.bottom()});
    addAxis(*chart, axisOf(x, chartPlace.width(), kLeastTick), Qt::AlignBottom, painter.font(), colours);
    addAxis(*chart, axisOf(y, chartPlace.height(), kTickLeading * metrics.height()), Qt::AlignLeft, painter.font(), colours);
    for (const PlotReference& reference : m_plot.references)
        if (y.places(reference.y))
            addRule(*chart, {onAxis(x, x.first), onAxis(y, reference.y)}, {onAxis(x, x.last), onAxis(y, reference.y)},
                    referencePen(colours));
    addLines(*chart, m_plot, x, y, colours);
    paintChart(painter, chartPlace, std::move(chart), [&](const PlaceOf& placeOf) {
        painter.setPen(colours.text);
        for (const PlotReference& reference : m_plot.references)
            if (y.places(reference.y))
                painter.drawText(
                    placeOf({onAxis(x, x.last), onAxis(y, reference.y)}) + QPointF(kLabelGap, metrics.ascent() / 2 - 1.0),
                    numberText(reference.y));
    });
    words.paint(painter, colours);
}

}  // namespace cullscope::ui
