#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "core/experiments/experiment.h"
#include "ui/jobs/answer.h"
#include "ui/jobs/background.h"
#include "ui/jobs/experiment_runner.h"
#include "ui/session/session.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Reproduces a table of a paper while an audience watches: core's `runExperiment`, on a thread of its own, with the window as
/// its stage. The session shows each setting's scene at the pose being measured, in as many views of its size as the setting has
/// windows, while an ExperimentRunner measures between the pictures. At the end, and after a cancel, the session's former state
/// is restored. If the user opens another scene, the run stops and that scene stays.
class PaperRunner : public QObject {
    Q_OBJECT

public:
    explicit PaperRunner(Session& session, QObject* parent = nullptr);

    /// What makes a recorder for each run, which puts its measurements into a store; null: none is made.
    void recordBy(std::function<std::shared_ptr<store::Recorder>()> make) { m_makeRecorder = std::move(make); }
    /// Starts a run. `repetitions` of each frame; 0: until the median is steady.
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
    /// The experiment's thread, and what it asks the window for.
    [[nodiscard]] Background::Delivery run(uint64_t number, const Experiment& experiment, const ExperimentOptions& options,
                                           const std::stop_token& stop);
    /// Posts work from the experiment's thread to this object's; dropped if the run has ended by then.
    void post(uint64_t number, std::function<void()> work);
    [[nodiscard]] Progress progressOf(uint64_t number, const std::stop_token& stop);

    /// Shows a setting; the answer comes when the window has built and uploaded it, so that this work is not in the times.
    /// `opened`: null where the setting names no scene.
    void show(size_t setting, const OpenedScenePointer& opened, std::shared_ptr<Answer<ScenePointer>> shown);
    void answerWhenShown();
    void measure(const MeasureRequest& request, const Progress& progress, std::shared_ptr<Answer<MeasureResult>> measured);
    void showPose(double share);
    void fail(const Message& message);
    void end();
    void restoreSession();
    [[nodiscard]] const Setting& setting() const { return m_experiment->settings[m_setting]; }

    Session& m_session;
    ExperimentRunner m_runner;
    QTimer m_shownCheck;
    std::shared_ptr<const Experiment> m_experiment;  ///< null: no run is active
    uint64_t m_run = 0;                              ///< number of the newest run
    size_t m_setting = 0;                            ///< the one that is shown
    double m_share = 0.0;
    ResultTable m_table;
    CameraPath m_path;  ///< path of the setting being measured
    std::function<std::shared_ptr<store::Recorder>()> m_makeRecorder;
    std::shared_ptr<store::Recorder> m_recorder;        ///< of the newest run
    Progress m_measuring;                               ///< of the setting being measured
    bool m_resultDue = false;                           ///< a setting is being measured, or its rows are being made
    bool m_showing = false;                             ///< this object itself is changing the session's scene
    std::shared_ptr<Answer<ScenePointer>> m_shown;      ///< due when the setting is shown; null: none is
    std::shared_ptr<Answer<MeasureResult>> m_measured;  ///< due when the setting is measured; null: none is
    OpenedScenePointer m_openedBefore;
    std::optional<Pick> m_pickBefore;
    std::optional<SessionState> m_before;  ///< state to restore; none: restore nothing
    Background m_background;               ///< the experiment's thread
};

}  // namespace cullscope::ui
