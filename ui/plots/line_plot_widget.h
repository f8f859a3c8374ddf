#pragma once

#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// A plot that core describes: a paper's figure, the paper's levels as thin lines across with their numbers behind.
class LinePlotWidget : public PlotWidget {
    Q_OBJECT

public:
    explicit LinePlotWidget(QWidget* parent = nullptr);

    /// A plot without lines is shown too, with its axes and levels.
    void setPlot(const LinePlot& plot);
    [[nodiscard]] const LinePlot& plot() const { return m_plot; }

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_plot.title.empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    LinePlot m_plot;
};

}  // namespace cullscope::ui
