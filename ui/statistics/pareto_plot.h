#pragma once

#include "ui/plots/plot_widget.h"
#include "ui/statistics/run_sweeps.h"

namespace cullscope::ui {

/// What speed costs in accuracy: speed against `backface` to the right, missed parts per million upwards on a logarithmic scale,
/// nothing missed on a band of its own. Each point has its strategy's name beside it; its shape is the promise. Runs of one
/// strategy that differ in one parameter are joined by a line and have that parameter's value beside them.
class ParetoPlot : public PlotWidget {
    Q_OBJECT

public:
    explicit ParetoPlot(QWidget* parent = nullptr);

    /// Runs whose loss was not measured have no place here and are left out.
    void setRuns(const std::vector<RunFigures>& runs);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_runs.empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

    /// Where a loss stands on the vertical axis: its decade, or `lowestDecade() − 1` for nothing missed.
    [[nodiscard]] double height(double missedPpm) const;
    /// The logarithm of the lower end of the logarithmic part.
    [[nodiscard]] int lowestDecade() const;
    /// "0 (< 3/16)": nothing missed in 16 views.
    [[nodiscard]] QString zeroLabel() const;

protected:
    [[nodiscard]] QString emptySentence() const override;
    [[nodiscard]] QString description() const override;

private:
    [[nodiscard]] int highestDecade() const;
    [[nodiscard]] PlotAxis lossAxis() const;
    /// By run: its sweep's where it lies on one.
    [[nodiscard]] std::vector<QColor> runColours(const PlotColours& colours) const;
    /// What stands beside a run's point.
    [[nodiscard]] QString shortLabel(size_t run) const;
    /// None: the run lies on no sweep. Of a run on several the first.
    [[nodiscard]] const RunSweep* sweepOf(size_t run) const;
    void addSweeps(LinePlot& plot, const PlotColours& colours) const;
    void addRuns(LinePlot& plot, const PlotColours& colours) const;

    std::vector<RunFigures> m_runs;
    std::vector<RunSweep> m_sweepLines;
    bool m_lossUnknown = false;  ///< there are runs, but none whose loss was measured
};

}  // namespace cullscope::ui
