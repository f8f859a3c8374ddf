#include "ui/window/paper_commands.h"

#include <QCoreApplication>

#include "ui/dialogs/advise_dialog.h"
#include "ui/dialogs/figures_dialog.h"
#include "ui/dialogs/reports_dialog.h"
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
    connect(actions.figures, &QAction::triggered, this, [this] { (void)shown<FiguresDialog>(); });
    connect(actions.stability, &QAction::triggered, this, [this] {
        connect(&shown<StabilityDialog>(), &StabilityDialog::sceneWanted, this, &PaperCommands::sceneWanted,
                Qt::UniqueConnection);
    });
    connect(actions.advise, &QAction::triggered, this, [this] {
        connect(&shown<AdviseDialog>(), &AdviseDialog::strategyWanted, &m_experiments, &Experiments::showStrategy,
                Qt::UniqueConnection);
    });
    connect(actions.worst, &QAction::triggered, this, [this] { (void)shown<WorstDialog>(); });
    connect(actions.reports, &QAction::triggered, this, [this] { (void)shown<ReportsDialog>(); });
    m_runner->recordBy([this] { return m_experiments.recorder(); });
    connect(m_runner, &PaperRunner::ended, &m_experiments, &Experiments::readHistory);
    // The changes that the experiment made to the session are not steps for the user to undo.
    connect(m_runner, &PaperRunner::ended, &undo, &UndoRecorder::startAnew);
}

template <typename Dialog>
Dialog& PaperCommands::shown() {
    auto* dialog = m_window->findChild<Dialog*>();
    if (dialog == nullptr) {
        dialog = new Dialog(m_session, m_window);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
    }
    dialog->show();
    dialog->raise();
    return *dialog;
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
