// What the panel of statistics shows is brought up to date.
#include "ui/statistics/statistics_panel.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/wheel_guard.h"
#include "ui/plots/result_exporter.h"
#include "ui/statistics/flow_layout.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/path_plot.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/run_figures.h"
#include "ui/statistics/sphere_map.h"
#include "ui/statistics/time_bar.h"

namespace cullscope::ui {

namespace {

std::vector<TimeBar::Entry> timesOf(const std::vector<RunFigures>& runs) {
    std::vector<TimeBar::Entry> entries;
    for (const RunFigures& run : runs)
        entries.push_back({run.label, run.cullMilliseconds, run.frameMilliseconds - run.cullMilliseconds, run.baseline});
    return entries;
}

std::vector<TimeBar::Entry> timesOf(const std::vector<LiveFigures>& views) {
    std::vector<TimeBar::Entry> entries;
    for (const LiveFigures& view : views) {
        if (view.figures.state != ViewMetrics::State::Ready || !view.figures.timed) continue;
        const double cull = view.figures.cullMilliseconds;
        entries.push_back({view.view + QStringLiteral(" · ") + runLabel(view.strategy), cull,
                           view.figures.frameMilliseconds - cull,
                           findStrategy(view.strategy.id).info.baseline != BaselineRole::None});
    }
    return entries;
}

size_t measuredPoses(const MeasureResult& result) { return result.runs.empty() ? 0 : result.runs.front().frames.size(); }

}  // namespace

void StatisticsPanel::scheduleRefresh() {
    if (m_pause.isActive()) {
        m_waiting = true;
        return;
    }
    refresh();
}

void StatisticsPanel::refresh() {
    m_waiting = false;
    m_pause.start();
    const std::vector<RunFigures> runs = m_result ? runFigures(*m_result) : std::vector<RunFigures>();
    if (showsExperiment()) {
        m_model->setRows(m_result ? resultRows(m_resultTable) : std::vector<ResultRow>());
        m_times->setEntries(timesOf(runs));
    } else {
        m_model->setRows(liveRows(m_live));
        m_times->setEntries(timesOf(m_live));
    }
    m_path->setRuns(runs, m_result ? m_result->request.path.poses.size() : 0);
    m_pareto->setRuns(runs);
    refreshTablePage();
    fillRuns();
    refreshPoses();
    refreshRace();
    refreshControls();
}

void StatisticsPanel::refreshTablePage() {
    m_tableEmpty->setText(!m_scene                         ? tr("Open a scene: its figures appear here.")
                          : showsExperiment() && m_running ? tr("Being measured…")
                          : showsExperiment() ? tr("Nothing is measured yet. Choose a camera path above and press Start.")
                                              : tr("The views' figures appear here as soon as they are measured."));
    if (m_model->rowCount() > 0)
        m_tablePage->setCurrentWidget(m_table);
    else
        m_tablePage->setCurrentWidget(m_tableEmpty);
}

void StatisticsPanel::fillRuns() {
    QStringList labels;
    int usual = 0;
    if (m_result)
        for (const RunMeasurement& run : m_result->runs) {
            if (labels.size() == usual && findStrategy(run.strategy.id).info.baseline != BaselineRole::None) ++usual;
            labels << runLabel(run.strategy);
        }
    QStringList before;
    for (int row = 0; row < m_run->count(); ++row) before << m_run->itemText(row);
    if (labels == before) return;
    m_run->clear();
    m_run->addItems(labels);
    m_run->setCurrentIndex(usual < labels.size() ? usual : 0);
}

void StatisticsPanel::refreshPoses() {
    const int chosen = m_run->currentIndex();
    const std::vector<RunFigures> runs = m_result ? runFigures(*m_result) : std::vector<RunFigures>();
    const bool known = chosen >= 0 && size_t(chosen) < runs.size();
    for (PosePlot* plot : std::initializer_list<PosePlot*>{m_strip, m_sphere})
        plot->setRun(known ? runs[size_t(chosen)] : RunFigures(), known ? m_result->request.path.poses.size() : 0);
}

void StatisticsPanel::refreshControls() {
    const int tab = m_tabs->currentIndex();
    m_source->setVisible(tab == Table || tab == Times);
    m_chooseColumns->setVisible(tab == Table);
    for (QComboBox* box : {m_across, m_up}) box->setVisible(tab == Pareto);
    m_run->setVisible((tab == Poses || tab == Sphere) && m_run->count() > 0);
    const bool measured = m_result && measuredPoses(*m_result) > 0;
    const PlotWidget* plot = currentPlot();
    for (QAction* action : m_menu->actions()) {
        const auto file = File(action->data().toInt());
        const bool ofPlot = file == File::Svg || file == File::Pdf;
        action->setEnabled(ofPlot ? plot && !plot->empty() : measured);
    }
    refreshSummary();
}

void StatisticsPanel::refreshSummary() {
    if (!m_result || m_tabs->currentIndex() == History ||
        ((m_tabs->currentIndex() == Table || m_tabs->currentIndex() == Times) && !showsExperiment())) {
        m_summary->hide();
        return;
    }
    const MeasureRequest& request = m_result->request;
    //: A camera path with the size of the picture, and how many of the path's poses were measured.
    m_summary->setText(
        tr("%1 · %2 of %3 poses").arg(pathAndSize(request)).arg(measuredPoses(*m_result)).arg(request.path.poses.size()));
    m_summary->show();
    if (m_result->gl.software) m_software->show();
}

}  // namespace cullscope::ui
