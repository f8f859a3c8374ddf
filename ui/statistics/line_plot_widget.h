#pragma once

#include <QChart>

#include "core/image/line_plot.h"
#include "ui/statistics/plot_legend.h"
#include "ui/statistics/plot_widget.h"

namespace cullscope::ui {

/// Lines over two axes, as core has them: a paper's figure, the paper's levels as thin lines across with their numbers behind.
class LinePlotWidget : public PlotWidget {
    Q_OBJECT

public:
    explicit LinePlotWidget(QWidget* parent = nullptr);

    /// A plot without lines is shown too, with its axes and levels.
    void setPlot(const LinePlot& plot);
    [[nodiscard]] const LinePlot& plot() const { return m_plot; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_plot.title.empty(); }
    void paintPlot(QPainter& painter, const QRectF& place, const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    [[nodiscard]] PlotLegend legend(const PlotColours& colours, const QFont& font) const;

    LinePlot m_plot;
};

}  // namespace cullscope::ui
