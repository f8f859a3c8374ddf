#pragma once

#include <QObject>
#include <optional>
#include <vector>

#include "ui/jobs/experiment_runner.h"
#include "ui/session/session.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui {

/// Experiments over the shown views' strategies or over ready-made fronts, one at a time, and the present camera's figures:
/// whatever statistics panels are in the window show the same.
class Experiments : public QObject {
    Q_OBJECT

public:
    explicit Experiments(Session& session, QObject* parent = nullptr);

    /// A panel that shows and starts these experiments.
    [[nodiscard]] StatisticsPanel* makePanel(QWidget* parent = nullptr);
    /// Offers a path that the user flew; none takes it away again.
    void setRecordedPath(const std::optional<CameraPath>& path);
    [[nodiscard]] ExperimentRunner& runner() { return *m_runner; }

private:
    void wire();
    void start(const ExperimentSettings& settings);
    /// Of the shown views, each once.
    [[nodiscard]] std::vector<StrategyRequest> shownStrategies() const;
    void end();
    void show(const MeasureResult& result);
    void goToPose(int pose);
    void showLive(StatisticsPanel& panel) const;
    void showScene(StatisticsPanel& panel) const;

    Session& m_session;
    ExperimentRunner* m_runner;
    std::vector<StatisticsPanel*> m_panels;
    std::optional<CameraPath> m_recorded;
    std::optional<MeasureResult> m_result;  ///< the newest, partial or whole
    bool m_running = false;
    CameraPath m_path;  ///< of the newest experiment
};

}  // namespace cullscope::ui
