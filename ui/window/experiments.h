#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/jobs/scene_experiment.h"
#include "ui/session/session.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui {

/// Runs experiments over the strategies of the shown views or over predefined parameter sweeps, one at a time. All statistics
/// panels of the window show the same experiment, and the metrics at the present camera.
class Experiments : public QObject {
    Q_OBJECT

public:
    explicit Experiments(Session& session, QObject* parent = nullptr);

    /// Makes a panel that starts and shows these experiments.
    [[nodiscard]] StatisticsPanel* makePanel(QWidget* parent = nullptr);
    /// Offers a recorded camera path for experiments; none withdraws it.
    void setRecordedPath(const std::optional<CameraPath>& path);
    [[nodiscard]] SceneExperiment& runner() { return *m_runner; }
    /// Shows a strategy with its parameters in the active view, or in the one that it observes.
    void showStrategy(const StrategyRequest& strategy);

private:
    void wire();
    void start(const ExperimentSettings& settings);
    /// The strategies of the shown views, each once.
    [[nodiscard]] std::vector<StrategyRequest> shownStrategies() const;
    void end();
    /// Keeps the figures of what was measured, to be compared with later experiments, also at later starts.
    void remember();
    /// What is kept; what cannot be read is said once and begins anew.
    [[nodiscard]] std::vector<PastExperiment> kept();
    void show(const ResultTable& table, const MeasureResult& result);
    void goToPose(int pose);
    void showLive(StatisticsPanel& panel) const;
    void showScene(StatisticsPanel& panel) const;

    Session& m_session;
    SceneExperiment* m_runner;
    std::vector<StatisticsPanel*> m_panels;
    std::optional<CameraPath> m_recorded;
    std::optional<MeasureResult> m_result;  ///< the newest one, partial or complete
    ResultTable m_table;                    ///< of that result
    std::vector<PastExperiment> m_history;  ///< the newest last; kept in a file
    bool m_running = false;
};

}  // namespace cullscope::ui
