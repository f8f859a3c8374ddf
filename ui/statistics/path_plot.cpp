#include "ui/statistics/path_plot.h"

#include <algorithm>

#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// How each run is drawn; the baselines grey.
std::vector<PlotPen> pensOf(const std::vector<RunFigures>& runs, const PlotColours& colours) {
    std::vector<PlotPen> pens;
    size_t number = 0;
    for (const RunFigures& run : runs) {
        const PlotStroke stroke = run.role == BaselineRole::Triangles ? PlotStroke::Dotted : PlotStroke::Dashed;
        if (run.baseline)
            pens.push_back({colours.faintText.rgba(), 2.0, stroke});
        else
            pens.push_back({colours.series(number++).rgba(), 2.0});
    }
    return pens;
}

}  // namespace

PathPlot::PathPlot(QWidget* parent) : PlotWidget(parent) { contentsChanged(); }

void PathPlot::setRuns(std::vector<RunFigures> runs, size_t poseCount) {
    m_runs = std::move(runs);
    m_poseCount = poseCount;
    contentsChanged();
}

QString PathPlot::title() const { return tr("Along the path"); }

bool PathPlot::lossKnown() const {
    return std::any_of(m_runs.begin(), m_runs.end(),
                       [](const RunFigures& run) { return run.poses.front().missedPpm.has_value(); });
}

QString PathPlot::description() const {
    QStringList lines;
    for (const RunFigures& run : m_runs)
        lines << tr("%1: %2 a frame on average").arg(run.label, millisecondsText(run.frameMilliseconds));
    return lines.join(QLatin1Char('\n'));
}

std::vector<LinePlot> PathPlot::plots(const QPalette& palette) const {
    LinePlot times;
    times.x = {{}, PlotScale::Linear, 0.0, std::max(1.0, double(m_poseCount) - 1.0), false, true};
    times.y = {tr("Frame time in ms, by pose").toStdString(), PlotScale::Linear, 0.0, 0.0, true};
    LinePlot losses = times;
    losses.y.title = tr("Missed pixels, by pose").toStdString();
    losses.y.whole = true;
    const std::vector<PlotPen> pens = pensOf(m_runs, PlotColours(palette));
    for (size_t i = 0; i < m_runs.size(); ++i) {
        PlotLine time;
        time.name = m_runs[i].label.toStdString();
        time.pen = pens[i];
        PlotLine loss = time;
        for (const PoseFigures& pose : m_runs[i].poses) {
            time.points.push_back({double(pose.pose), pose.frameMilliseconds});
            loss.points.push_back({double(pose.pose), double(pose.missedPixels)});
        }
        times.lines.push_back(std::move(time));
        losses.lines.push_back(std::move(loss));
    }
    if (!lossKnown()) return {std::move(times)};
    return {std::move(times), std::move(losses)};
}

}  // namespace cullscope::ui
