#include "ui/plots/flow_chart_plot.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>

#include "ui/plots/plot_painter.h"
#include "ui/text/translated.h"

namespace cullscope::ui {

namespace {

FlowColours coloursFor(const PlotColours& plot) {
    FlowColours colours;
    colours.line = plot.faintText.rgba();
    colours.structure = plot.grid.rgba();
    return colours;
}

}  // namespace

FlowChartPlot::FlowChartPlot(QWidget* parent) : PlotWidget(parent) { setFocusPolicy(Qt::StrongFocus); }

void FlowChartPlot::setChart(const FlowChart& chart, uint8_t line) {
    m_chart = chart;
    m_line = line;
    contentsChanged();
}

QString FlowChartPlot::title() const { return tr("Flow chart"); }

QString FlowChartPlot::description() const {
    QStringList lines;
    for (const FlowBox& box : m_chart.boxes) {
        const bool lit = m_line > 0 && std::ranges::find(box.lines, m_line) != box.lines.end();
        lines << (lit ? tr("%1: the step in hand").arg(translated(box.text)) : translated(box.text));
    }
    return lines.join(QLatin1Char('\n'));
}

PlotDrawing FlowChartPlot::laidOut(double width, double& height, const QFont& font, const QPalette& palette) const {
    const PlotColours colours(palette);
    return drawFlowChart(m_chart, m_line, width, height, plotStyle(font, colours), coloursFor(colours),
                         [](const std::string& text) { return translated(text).toStdString(); });
}

void FlowChartPlot::paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const {
    double height = 0.0;
    const PlotDrawing drawing = laidOut(place.width(), height, painter.font(), palette);
    painter.save();
    painter.translate(place.topLeft());
    paintDrawing(painter, drawing);
    painter.restore();
}

QRect FlowChartPlot::litPlace() const {
    double height = 0.0;
    for (const auto& item : laidOut(width(), height, font(), palette()).items) {
        const auto* path = std::get_if<DrawnPath>(&item);
        if (path == nullptr || path->fill != FlowColours().lit) continue;
        QPolygonF outline;
        for (const PlotPoint& point : path->points) outline << QPointF(point.x, point.y);
        return outline.boundingRect().toAlignedRect();
    }
    return {};
}

int FlowChartPlot::neededHeight(int width) const {
    if (m_chart.empty()) return PlotWidget::neededHeight(width);
    double height = 0.0;
    (void)laidOut(width, height, font(), palette());
    return int(std::ceil(height));
}

}  // namespace cullscope::ui
