#pragma once

#include <vector>

#include "ui/plots/plot_widget.h"
#include "ui/statistics/run_figures.h"

namespace cullscope::ui {

/// A plot of one strategy by pose, in which a pose can be chosen: by a click, or by the arrow keys and Enter. Its values are in
/// the tooltip.
class PosePlot : public PlotWidget {
    Q_OBJECT

public:
    explicit PosePlot(QWidget* parent = nullptr);

    /// What it shows and of which strategy.
    [[nodiscard]] QString title() const final;
    /// `poseCount`: of the whole path, of which `run` may have measured a part only.
    void setRun(RunFigures run, size_t poseCount);
    [[nodiscard]] bool empty() const override { return m_run.poses.empty(); }
    /// The pose under the keyboard's cursor: an index into what was measured, −1 where none is.
    [[nodiscard]] int current() const { return m_current; }

signals:
    void poseChosen(int pose);

protected:
    bool event(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    [[nodiscard]] QString description() const override;

    /// What it shows of any strategy, in the user's language.
    [[nodiscard]] virtual QString subject() const = 0;
    /// The index into the measured poses at a place of the widget; −1 where none is.
    [[nodiscard]] virtual int poseAt(const QPointF& place) const = 0;
    [[nodiscard]] const RunFigures& run() const { return m_run; }
    [[nodiscard]] size_t poseCount() const { return m_poseCount; }
    [[nodiscard]] QString poseText(const PoseFigures& pose) const;

private:
    void showValues(const QPointF& place, const QPoint& onScreen);
    void setCurrent(int index);
    void choose(int index);

    RunFigures m_run;
    size_t m_poseCount = 0;
    int m_current = -1;
};

}  // namespace cullscope::ui
