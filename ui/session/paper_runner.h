#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/experiments/experiment.h"
#include "ui/jobs/background.h"
#include "ui/jobs/experiment_runner.h"
#include "ui/session/session.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Reproduces a table of a paper while an audience watches: the session shows each setting's scene at the pose being measured, in
/// as many views of its size as the setting has windows, while an ExperimentRunner measures between the pictures. At the end, and
/// after a cancel, the session's former state is restored. If the user opens another scene, the run stops and that scene stays.
class PaperRunner : public QObject {
    Q_OBJECT

public:
    explicit PaperRunner(Session& session, QObject* parent = nullptr);

    /// Starts a run. `repetitions` of each frame; 0: until the median is steady. `experiment` must outlive the run.
    void start(const Experiment& experiment, int repetitions = 0);
    /// Stops the run when the current frame is done; the results so far stay in the table.
    void cancel();
    [[nodiscard]] bool running() const { return m_experiment != nullptr; }
    /// The results of the newest run so far.
    [[nodiscard]] const ResultTable& table() const { return m_table; }
    /// The finished fraction of all settings of the newest run, in [0, 1]; never decreases.
    [[nodiscard]] double share() const { return m_share; }

signals:
    /// `share` in [0, 1] of all settings, never decreasing; `stage` is one of core's English names.
    void progressed(double share, const QString& stage);
    /// Rows were added to the table.
    void tableChanged();
    /// The table's plots have more points.
    void plotsChanged();
    /// The run has ended and the session's former state is restored.
    void ended();

private:
    void nextSetting();
    void openScene();
    void showSetting();
    /// Starts measuring after the window has built and uploaded the setting, so that this work is not in the times.
    void measureWhenShown();
    void measureSetting();
    void buildSetting();
    void addRows(std::function<void(ResultTable& table, const Progress& progress)> add);
    void showPose(double share);
    void settingDone();
    void fail(const Message& message);
    void end();
    void restoreSession();
    [[nodiscard]] const Setting& setting() const { return m_experiment->settings[m_setting]; }
    [[nodiscard]] Progress progressOn(const std::stop_token& stop);
    void tellProgress(double share, const QString& stage);

    Session& m_session;
    ExperimentRunner m_runner;
    Background m_background;  ///< opens scenes, builds structures, makes rows
    QTimer m_shownCheck;
    const Experiment* m_experiment = nullptr;  ///< null: no run is active
    size_t m_setting = 0;
    int m_repetitions = 0;
    double m_share = 0.0;
    ResultTable m_table;
    CameraPath m_path;            ///< path of the setting being measured
    std::string m_specification;  ///< of the scene that the run has opened
    bool m_resultDue = false;     ///< a setting is being measured, or its rows are being made
    bool m_showing = false;       ///< this object itself is changing the session's scene
    OpenedScenePointer m_openedBefore;
    std::optional<Pick> m_pickBefore;
    std::optional<SessionState> m_before;  ///< state to restore; none: restore nothing
};

}  // namespace cullscope::ui
