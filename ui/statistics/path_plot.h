#pragma once

#include "ui/plots/plot_widget.h"
#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

/// The frame time of every strategy along the path, and beside it (below it, where there is little place) its missed pixels.
class PathPlot : public PlotWidget {
    Q_OBJECT

public:
    explicit PathPlot(QWidget* parent = nullptr);

    /// `poseCount`: of the whole path, of which the runs may have measured a part only.
    void setRuns(std::vector<RunFigures> runs, size_t poseCount);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_runs.empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

protected:
    [[nodiscard]] QString description() const override;

private:
    [[nodiscard]] bool lossKnown() const;

    std::vector<RunFigures> m_runs;
    size_t m_poseCount = 0;
};

}  // namespace cullscope::ui
