#pragma once

#include <vector>

#include "core/visibility/bars.h"
#include "ui/plots/plot_widget.h"

namespace cullscope::ui {

/// Counts of a frame as bars to the right, with their names before and their numbers behind them.
class BarsPlot : public PlotWidget {
    Q_OBJECT

public:
    explicit BarsPlot(QWidget* parent = nullptr);

    void setBars(const std::vector<Bars>& bars);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_bars.empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;
    [[nodiscard]] int neededHeight(int width) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    std::vector<Bars> m_bars;
};

}  // namespace cullscope::ui
