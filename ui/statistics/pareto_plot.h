#pragma once

#include "core/experiments/trade_plot.h"
#include "ui/plots/plot_widget.h"
#include "ui/statistics/run_sweeps.h"

namespace cullscope::ui {

/// What one figure costs in another: at first speed to the right, and missed parts per million upwards on a logarithmic scale,
/// nothing missed on a band of its own. Each point has its strategy's name beside it; its shape is the promise. Runs of one
/// strategy that differ in one parameter are joined by a line and have that parameter's value beside them. A point's values are
/// in the tooltip; a click, or the arrow keys and Enter, choose its strategy.
class ParetoPlot : public PlotWidget {
    Q_OBJECT

public:
    explicit ParetoPlot(QWidget* parent = nullptr);

    /// Runs of which one of both figures was not measured have no place here and are left out.
    void setRuns(const std::vector<RunFigures>& runs);
    void setAxes(const TradeFigure& across, const TradeFigure& up);

    [[nodiscard]] QString title() const override;
    [[nodiscard]] bool empty() const override { return m_plot.empty(); }
    [[nodiscard]] std::vector<LinePlot> plots(const QPalette& palette) const override;

    /// Where a loss stands on the vertical axis: its decade, or `lowestDecade() − 1` for nothing missed.
    [[nodiscard]] double height(double missedPpm) const;
    /// The logarithm of the lower end of the logarithmic part.
    [[nodiscard]] int lowestDecade() const;
    /// "0 (< 3/16)": nothing missed in 16 views.
    [[nodiscard]] QString zeroLabel() const;
    /// Where a run's point is in the window; none: it has no place.
    [[nodiscard]] std::optional<QPointF> pointOf(size_t run) const;
    /// The words about it.
    [[nodiscard]] QString pointText(size_t run) const;

signals:
    /// A point's strategy is to be shown in a view.
    void strategyChosen(const cullscope::StrategyRequest& strategy);

protected:
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    [[nodiscard]] QString emptySentence() const override;
    [[nodiscard]] QString description() const override;

private:
    void layOut();
    [[nodiscard]] TradeLook look(const QPalette& palette) const;
    [[nodiscard]] TradePoint pointFor(size_t run) const;
    /// What stands beside a run's point.
    [[nodiscard]] QString shortLabel(size_t run) const;
    /// The run whose point is nearest to a place of the widget; none: it is not near.
    [[nodiscard]] std::optional<size_t> runAt(const QPointF& place) const;
    void showValues(const QPointF& place, const QPoint& onScreen);
    void choose(size_t run);

    std::vector<RunFigures> m_runs;
    std::vector<RunSweep> m_sweepLines;
    std::vector<size_t> m_placed;  ///< by point of the plot: its run
    const TradeFigure *m_across, *m_up;
    TradePlot m_plot;
    std::optional<size_t> m_current;  ///< point under the keyboard's cursor
};

}  // namespace cullscope::ui
