#pragma once

#include <QObject>
#include <QSettings>

#include "ui/session/camera_player.h"
#include "ui/session/camera_recorder.h"
#include "ui/window/experiments.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands that record and play a camera path.
class PathCommands : public QObject {
    Q_OBJECT

public:
    PathCommands(Session& session, WindowActions& actions, Experiments& experiments, QWidget* window);

    [[nodiscard]] CameraRecorder& recorder() { return *m_recorder; }
    [[nodiscard]] CameraPlayer& player() { return *m_player; }

private:
    void wire();
    void save();
    void open();
    void play(bool on);
    void playFromStart(const CameraPath& path);
    void refresh();
    void offerRecorded();
    /// Asks for a path file; returns an empty string if the user chose none. Starts in the folder of the last file.
    [[nodiscard]] QString askFile(bool save);

    Session& m_session;
    WindowActions& m_actions;
    QWidget* m_window;
    CameraRecorder* m_recorder;
    CameraPlayer* m_player;
    Experiments& m_experiments;
    CameraPath m_opened;
    QSettings m_settings;
};

}  // namespace cullscope::ui
