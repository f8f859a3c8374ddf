#pragma once

#include "core/image/flow_chart_drawing.h"
#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// A strategy as a flow chart, in which the boxes of the listing's current line are lit.
class FlowChartPlot : public PlotWidget {
    Q_OBJECT

public:
    explicit FlowChartPlot(QWidget* parent = nullptr);

    /// `line`: of the listing, from 1; 0: none is lit.
    void setChart(const FlowChart& chart, uint8_t line);
    [[nodiscard]] uint8_t line() const { return m_line; }

    /// Where the lit box lies; empty: none is lit.
    [[nodiscard]] QRect litPlace() const;

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_chart.empty(); }
    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    [[nodiscard]] PlotDrawing laidOut(double width, double& height, const QFont& font, const QPalette& palette) const;

    FlowChart m_chart;
    uint8_t m_line = 0;
};

}  // namespace cullscope::ui
