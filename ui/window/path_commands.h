#pragma once

#include <QObject>
#include <QSettings>

#include "ui/session/path_desk.h"
#include "ui/window/experiments.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands that record, make, play and keep a camera path.
class PathCommands : public QObject {
    Q_OBJECT

public:
    PathCommands(Session& session, WindowActions& actions, Experiments& experiments, QWidget* window);

    [[nodiscard]] PathDesk& desk() { return *m_desk; }
    [[nodiscard]] CameraRecorder& recorder() { return m_desk->recorder(); }
    [[nodiscard]] CameraPlayer& player() { return m_desk->player(); }

    void save();

private:
    void wire();
    void open();
    void play(bool on);
    void refresh();
    /// Asks for a path file; returns an empty string if the user chose none. Starts in the folder of the last file.
    [[nodiscard]] QString askFile(bool save);

    Session& m_session;
    WindowActions& m_actions;
    QWidget* m_window;
    PathDesk* m_desk;
    QSettings m_settings;
};

}  // namespace cullscope::ui
