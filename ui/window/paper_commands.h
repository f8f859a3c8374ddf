#pragma once

#include <QObject>

#include "ui/session/paper_runner.h"
#include "ui/session/undo_recorder.h"
#include "ui/window/experiments.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands that reproduce a table of a paper in the window, that draw its figures, that run the battery of extreme cases,
/// that advise on the scene, and that search for the worst view.
class PaperCommands : public QObject {
    Q_OBJECT

public:
    PaperCommands(Session& session, WindowActions& actions, Experiments& experiments, UndoRecorder& undo, QWidget* window);

    [[nodiscard]] PaperRunner& runner() { return *m_runner; }

signals:
    /// A scene of the gallery is to be shown.
    void sceneWanted(const QString& scene);

private:
    void showDialog();
    /// Shows the window's dialog of that kind: one that is closed is made anew.
    template <typename Dialog>
    Dialog& shown();

    Session& m_session;
    Experiments& m_experiments;
    QWidget* m_window;
    PaperRunner* m_runner;
};

}  // namespace cullscope::ui
