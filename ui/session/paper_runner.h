#pragma once

#include <QObject>
#include <QTimer>
#include <optional>

#include "core/experiments/paper_tables.h"
#include "ui/jobs/background.h"
#include "ui/jobs/experiment_runner.h"
#include "ui/session/session.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Reproduces a paper's table before an audience: the session shows each setting's scene in as many views of its size as it has
/// windows, at the pose being measured, while an ExperimentRunner measures off the window. In the end, or when it is stopped,
/// the session is again what it was. A scene that somebody opens meanwhile stops it and stays.
class PaperRunner : public QObject {
    Q_OBJECT

public:
    explicit PaperRunner(Session& session, QObject* parent = nullptr);

    /// `repetitions` of each frame; 0: until the median is steady. The experiment must outlive the run.
    void start(const PaperExperiment& experiment, int repetitions = 0);
    /// Stops as soon as the frame under way is done; what was measured stays in the table.
    void cancel();
    [[nodiscard]] bool running() const { return m_experiment != nullptr; }
    /// Of the newest run: what was measured so far.
    [[nodiscard]] const PaperTable& table() const { return m_table; }
    /// Of the newest run: how much of all settings is done, in [0, 1]; it never falls.
    [[nodiscard]] double share() const { return m_share; }

signals:
    /// `share` in [0, 1] of all settings, never less than before; `stage` is one of core's English names.
    void progressed(double share, const QString& stage);
    /// The table has more rows.
    void tableChanged();
    /// The table's plots have more points: one more view is measured.
    void plotsChanged();
    /// Nothing is under way any more, and the session is what it was before.
    void ended();

private:
    void nextSetting();
    void openScene();
    void showSetting();
    /// Measures once the window has drawn the setting: what it builds and uploads would be in the times.
    void measureWhenShown();
    void measureSetting();
    void buildSetting();
    void addRows(std::function<void(PaperTable& table, const Progress& progress)> add);
    void showPose(double share);
    void settingDone();
    void fail(const Message& message);
    void end();
    void restoreSession();
    [[nodiscard]] const PaperSetting& setting() const { return m_experiment->settings[m_setting]; }
    [[nodiscard]] Progress progressOn(const std::stop_token& stop);
    void tellProgress(double share, const QString& stage);

    Session& m_session;
    ExperimentRunner m_runner;
    Background m_background;  ///< opens scenes, builds structures
    QTimer m_shownCheck;
    const PaperExperiment* m_experiment = nullptr;  ///< null: nothing is under way
    size_t m_setting = 0;
    int m_repetitions = 0;
    double m_share = 0.0;
    PaperTable m_table;
    CameraPath m_path;            ///< of the setting being measured
    std::string m_specification;  ///< of the scene that is shown for the experiment
    bool m_resultDue = false;     ///< a setting is being measured, or its rows are being made
    bool m_showing = false;       ///< the scene changes by us
    OpenedScenePointer m_openedBefore;
    std::optional<Pick> m_pickBefore;
    std::optional<SessionState> m_before;  ///< none: there is nothing to go back to
};

}  // namespace cullscope::ui
