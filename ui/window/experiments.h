#pragma once

#include <QObject>
#include <memory>
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
    /// Reads the history anew from the store and shows it; what cannot be read is said.
    void readHistory();
    /// A recorder into the store; null where that cannot be opened, which is said.
    [[nodiscard]] std::shared_ptr<store::Recorder> recorder();
    /// Shows a strategy with its parameters in the active view, or in the one that it observes.
    void showStrategy(const StrategyRequest& strategy);

private:
    void wire();
    void start(const ExperimentSettings& settings);
    /// The strategies of the shown views, each once.
    [[nodiscard]] std::vector<StrategyRequest> shownStrategies() const;
    void end();
    void compare(qint64 a, qint64 b, QWidget* parent);
    void exportPast(const std::vector<qint64>& numbers, const QString& path);
    void show(const ResultTable& table, const MeasureResult& result);
    void goToPose(int pose);
    void showLive(StatisticsPanel& panel) const;
    void showScene(StatisticsPanel& panel) const;

    Session& m_session;
    SceneExperiment* m_runner;
    std::vector<StatisticsPanel*> m_panels;
    std::optional<CameraPath> m_recorded;
    std::optional<MeasureResult> m_result;        ///< the newest one, partial or complete
    ResultTable m_table;                          ///< of that result
    std::vector<PastExperiment> m_history;        ///< of the store, the newest last
    std::shared_ptr<store::Recorder> m_recorder;  ///< of the newest experiment
    bool m_running = false;
};

}  // namespace cullscope::ui
