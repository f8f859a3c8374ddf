#include "ui/window/paper_commands.h"

#include <QCoreApplication>

#include "ui/dialogs/advise_dialog.h"
#include "ui/dialogs/figures_dialog.h"
#include "ui/dialogs/reproduce_dialog.h"
#include "ui/dialogs/stability_dialog.h"
#include "ui/dialogs/worst_dialog.h"

namespace cullscope::ui {

PaperCommands::PaperCommands(Session& session, WindowActions& actions, Experiments& experiments, UndoRecorder& undo,
                             QWidget* window)
    : QObject(window),
      m_session(session),
      m_experiments(experiments),
      m_window(window),
      m_runner(new PaperRunner(session, this)) {
    connect(actions.reproduce, &QAction::triggered, this, &PaperCommands::showDialog);
    connect(actions.figures, &QAction::triggered, this, &PaperCommands::showFigures);
    connect(actions.stability, &QAction::triggered, this, &PaperCommands::showStability);
    connect(actions.advise, &QAction::triggered, this, &PaperCommands::showAdvice);
    connect(actions.worst, &QAction::triggered, this, &PaperCommands::showWorst);
    // The changes that the experiment made to the session are not steps for the user to undo.
    connect(m_runner, &PaperRunner::ended, &undo, &UndoRecorder::startAnew);
}

void PaperCommands::showStability() {
    auto* dialog = m_window->findChild<StabilityDialog*>();
    if (dialog == nullptr) {
        dialog = new StabilityDialog(m_session, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &StabilityDialog::sceneWanted, this, &PaperCommands::sceneWanted);
    }
    dialog->show();
    dialog->raise();
}

void PaperCommands::showFigures() {
    auto* dialog = m_window->findChild<FiguresDialog*>();
    if (dialog == nullptr) {
        dialog = new FiguresDialog(m_session, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
}

void PaperCommands::showAdvice() {
    auto* dialog = m_window->findChild<AdviseDialog*>();
    if (dialog == nullptr) {
        dialog = new AdviseDialog(m_session, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &AdviseDialog::strategyWanted, &m_experiments, &Experiments::showStrategy);
    }
    dialog->show();
    dialog->raise();
}

void PaperCommands::showWorst() {
    auto* dialog = m_window->findChild<WorstDialog*>();
    if (dialog == nullptr) {
        dialog = new WorstDialog(m_session, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
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
