#include "ui/plots/bars_plot.h"

#include <algorithm>
#include <cmath>

#include "ui/look/verdict_swatch.h"
#include "ui/text/translated.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kHalfBar = 0.36;    // of a row
constexpr double kRow = 1.6;         // lines of text
constexpr double kRowsOfPlot = 5.0;  // lines of text that every plot has room for

}  // namespace

BarsPlot::BarsPlot(QWidget* parent) : PlotWidget(parent) { setFocusPolicy(Qt::StrongFocus); }

void BarsPlot::setBars(const std::vector<Bars>& bars) {
    m_bars = bars;
    contentsChanged();
}

QString BarsPlot::title() const { return m_bars.size() == 1 ? translated(m_bars.front().title) : tr("Counts"); }

QString BarsPlot::description() const {
    QStringList lines;
    for (const Bars& bars : m_bars) {
        lines << translated(bars.title);
        for (const Bar& bar : bars.bars) lines << QStringLiteral("%1: %2").arg(translated(bar.name), countText(bar.value));
    }
    return lines.join(QLatin1Char('\n'));
}

std::vector<LinePlot> BarsPlot::plots(const QPalette& palette) const {
    const PlotColours colours(palette);
    std::vector<LinePlot> plots;
    for (const Bars& bars : m_bars) {
        LinePlot& plot = plots.emplace_back();
        plot.title = translated(bars.title).toStdString();
        plot.x.zero = plot.x.whole = true;
        plot.y.least = 0.0;
        plot.y.most = double(bars.bars.size());
        for (size_t i = 0; i < bars.bars.size(); ++i) {
            const Bar& bar = bars.bars[i];
            const double middle = double(bars.bars.size() - i) - 0.5;
            const QColor colour = bar.colour ? verdictColour(*bar.colour, palette) : colours.draw;
            plot.y.ticks.push_back({middle, translated(bar.name).toStdString()});
            plot.bars.push_back({{},
                                 colour.rgba(),
                                 {{0.0, middle + kHalfBar, double(bar.value), middle - kHalfBar}},
                                 {countText(bar.value).toStdString()}});
        }
    }
    return plots;
}

int BarsPlot::neededHeight(int width) const {
    size_t rows = 0;
    for (const Bars& bars : m_bars) rows = std::max(rows, bars.bars.size());
    // No name may be left out for want of room.
    const double more = std::max(0.0, kRow * double(rows) - kRowsOfPlot) * QFontMetricsF(font()).height();
    return PlotWidget::neededHeight(width) + int(std::ceil(more * double(m_bars.size())));
}

}  // namespace cullscope::ui
