#pragma once

#include <QObject>

#include "ui/session/camera_player.h"
#include "ui/session/camera_recorder.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands that record a camera path and play one.
class PathCommands : public QObject {
    Q_OBJECT

public:
    PathCommands(Session& session, WindowActions& actions, QWidget* window);

    [[nodiscard]] CameraRecorder& recorder() { return *m_recorder; }
    [[nodiscard]] CameraPlayer& player() { return *m_player; }

private:
    void wire();
    void save();
    void open();
    void play(bool on);
    void refresh();

    Session& m_session;
    WindowActions& m_actions;
    QWidget* m_window;
    CameraRecorder* m_recorder;
    CameraPlayer* m_player;
    CameraPath m_opened;
};

}  // namespace cullscope::ui
