#include "ui/window/paper_commands.h"

#include <QCoreApplication>

#include "ui/dialogs/reproduce_dialog.h"

namespace cullscope::ui {

PaperCommands::PaperCommands(Session& session, WindowActions& actions, Experiments& experiments, UndoRecorder& undo,
                             QWidget* window)
    : QObject(window),
      m_session(session),
      m_experiments(experiments),
      m_window(window),
      m_runner(new PaperRunner(session, this)) {
    connect(actions.reproduce, &QAction::triggered, this, &PaperCommands::showDialog);
    // The changes that the experiment made to the session are not steps for the user to undo.
    connect(m_runner, &PaperRunner::ended, &undo, &UndoRecorder::startAnew);
}

void PaperCommands::showDialog() {
    if (m_experiments.runner().running() || m_runner->running()) {
        m_session.raise(Severity::Warning,
                        {QT_TRANSLATE_NOOP("core", "Another experiment is under way: let it end, or cancel it."), {}});
        return;
    }
    auto* dialog = new ReproduceDialog(m_session, *m_runner, m_window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    // Modal: the user sees the views but cannot change them during the measurement.
    dialog->setWindowModality(Qt::WindowModal);
    dialog->show();
}

}  // namespace cullscope::ui
