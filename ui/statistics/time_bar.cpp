#include "ui/statistics/time_bar.h"

#include <algorithm>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kBarMargin = 10.0;
constexpr double kGap = 8.0;
constexpr double kWide = 640.0;  // pixels; from this width on the label is beside the bar, and both parts of the time are stated

}  // namespace

TimeBar::TimeBar(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void TimeBar::setEntries(std::vector<Entry> entries) {
    m_entries = std::move(entries);
    m_longest = 0.0;
    for (const Entry& entry : m_entries) m_longest = std::max(m_longest, entry.frameMilliseconds());
    contentsChanged();
}

QString TimeBar::title() const { return tr("Time of a frame"); }

QString TimeBar::figuresOf(const Entry& entry, bool whole) const {
    const QString total = millisecondsText(entry.frameMilliseconds());
    if (!whole) return total;
    //: A frame's time: total = culling + drawing
    return tr("%1 = %2 cull + %3 draw")
        .arg(total, millisecondsText(entry.cullMilliseconds), millisecondsText(entry.drawMilliseconds));
}

QString TimeBar::description() const {
    QStringList rows;
    for (const Entry& entry : m_entries) rows << entry.label + QStringLiteral(": ") + figuresOf(entry, true);
    return rows.join(QLatin1Char('\n'));
}

TimeBar::Columns TimeBar::columns(const QFontMetricsF& metrics, double width) const {
    Columns columns;
    double labels = 0.0;
    for (const Entry& entry : m_entries) {
        labels = std::max(labels, metrics.horizontalAdvance(entry.label));
        columns.figures = std::max(columns.figures, metrics.horizontalAdvance(figuresOf(entry, width >= kWide)));
    }
    columns.legend = metrics.height() + 6.0;
    const bool beside = labels < 0.3 * width;
    columns.labels = beside ? labels : 0.0;
    columns.row = beside ? metrics.height() + 8.0 : 2.0 * metrics.height() + 8.0;
    return columns;
}

int TimeBar::neededHeight(int width) const {
    const Columns parts = columns(QFontMetricsF(font()), width);
    return int(parts.legend + parts.row * double(m_entries.size()) + kBarMargin);
}

void TimeBar::paintLegend(QPainter& painter, const QRectF& place, const PlotColours& colours) const {
    const double side = painter.fontMetrics().ascent();
    double x = place.left();
    for (const auto& [colour, baseline, word] : {std::tuple(colours.cull, colours.baselineCull, tr("cull")),
                                                 std::tuple(colours.draw, colours.baselineDraw, tr("draw"))}) {
        const double top = place.center().y() - side / 2;
        painter.fillRect(QRectF(x, top, side, side), colour);
        painter.fillRect(QRectF(x + side, top, side, side), baseline);
        painter.setPen(colours.text);
        const double width = painter.fontMetrics().horizontalAdvance(word);
        painter.drawText(QRectF(x + 2 * side + 4.0, place.top(), width + 1.0, place.height()), Qt::AlignVCenter, word);
        x += 2 * side + 4.0 + width + 2 * kGap;
    }
    painter.setPen(colours.faintText);
    painter.drawText(QRectF(x, place.top(), place.right() - x, place.height()), Qt::AlignVCenter | Qt::AlignRight,
                     tr("grey: %1 and %2", "two strategies")
                         .arg(baselineWord(BaselineRole::Triangles), baselineWord(BaselineRole::FrontFaces)));
}

void TimeBar::paintRow(QPainter& painter, const QRectF& row, const Columns& parts, const Entry& entry,
                       const PlotColours& colours) const {
    const double line = QFontMetricsF(painter.font()).height();
    const bool beside = parts.labels > 0.0;
    painter.setPen(colours.text);
    const QRectF label = beside ? QRectF(row.left(), row.top(), parts.labels + 1.0, row.height())
                                : QRectF(row.left(), row.top(), row.width(), line);
    painter.drawText(label, Qt::AlignVCenter | (beside ? Qt::AlignRight : Qt::AlignLeft), entry.label);
    const double left = beside ? row.left() + parts.labels + kGap : row.left();
    const double most = std::max(1.0, row.right() - parts.figures - kGap - left);
    const double scale = m_longest > 0.0 ? most / m_longest : 0.0;
    const double top = beside ? row.top() + 3.0 : row.top() + line + 1.0;
    const double height = beside ? row.height() - 6.0 : line;
    const double cull = entry.cullMilliseconds * scale;
    const double draw = entry.drawMilliseconds * scale;
    painter.fillRect(QRectF(left, top, cull, height), entry.baseline ? colours.baselineCull : colours.cull);
    painter.fillRect(QRectF(left + cull, top, draw, height), entry.baseline ? colours.baselineDraw : colours.draw);
    const QRectF figures(left + cull + draw + kGap, top, parts.figures + 1.0, height);
    painter.drawText(figures, Qt::AlignVCenter, figuresOf(entry, row.width() + 2 * kBarMargin >= kWide));
}

void TimeBar::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    const PlotColours colours(palette);
    const Columns parts = columns(QFontMetricsF(painter.font()), place.width());
    const QRectF inner = place.adjusted(kBarMargin, 0.0, -kBarMargin, 0.0);
    paintLegend(painter, QRectF(inner.left(), inner.top(), inner.width(), parts.legend), colours);
    QRectF row(inner.left(), inner.top() + parts.legend, inner.width(), parts.row);
    for (const Entry& entry : m_entries) {
        paintRow(painter, row, parts, entry, colours);
        row.translate(0.0, parts.row);
    }
}

}  // namespace cullscope::ui
