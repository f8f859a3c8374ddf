#include "ui/window/step_commands.h"

#include "ui/dialogs/answer_dialog.h"
#include "ui/models/prediction_model.h"

namespace cullscope::ui {

StepCommands::StepCommands(Session& session, WindowActions& actions, QWidget* window)
    : QObject(window),
      m_session(session),
      m_actions(actions),
      m_window(window),
      m_stepper(new Stepper(session, this)),
      m_questions(new QuestionFirst(session, this)) {
    connect(actions.questionFirst, &QAction::triggered, this,
            [this](bool on) { on ? m_questions->ask(m_questions->usualQuestion()) : m_questions->withdraw(); });
    connect(m_questions, &QuestionFirst::answered, this, &StepCommands::showAnswer);
    // Steps would answer an open question.
    connect(&session, &Session::questionChanged, this, [this] {
        if (m_session.question()) m_stepper->stop();
        refresh();
    });
    connect(actions.stepThrough, &QAction::triggered, this, [this](bool on) { on ? m_stepper->start() : m_stepper->stop(); });
    connect(actions.stepOn, &QAction::triggered, m_stepper, &Stepper::forward);
    connect(actions.stepBack, &QAction::triggered, m_stepper, &Stepper::back);
    connect(actions.stepFirst, &QAction::triggered, m_stepper, [this] { m_stepper->jump(0); });
    connect(actions.stepLast, &QAction::triggered, m_stepper, &Stepper::toEnd);
    connect(actions.stepToBreakpoint, &QAction::triggered, m_stepper, [this] { m_stepper->toBreakpoint(true); });
    connect(actions.stepBackToBreakpoint, &QAction::triggered, m_stepper, [this] { m_stepper->toBreakpoint(false); });
    connect(m_stepper, &Stepper::changed, this, &StepCommands::refresh);
    connect(&session, &Session::sceneChanged, this, &StepCommands::refresh);
    refresh();
}

void StepCommands::showAnswer(const Prediction& prediction, const std::vector<PredictionRow>& rows,
                              const NamedPartsPointer& parts) {
    auto* dialog = new AnswerDialog(new PredictionModel(m_session.scene(), prediction, rows, parts), m_window);
    dialog->show();
}

void StepCommands::refresh() {
    m_actions.stepThrough->setEnabled(m_session.opened() != nullptr && !m_session.question());
    m_actions.questionFirst->setEnabled(m_session.opened() != nullptr);
    m_actions.questionFirst->setChecked(m_session.question().has_value());
    m_actions.stepThrough->setChecked(m_stepper->active());
    // Without stepping, these keys belong to lists and tables.
    for (QAction* action : {m_actions.stepOn, m_actions.stepBack, m_actions.stepFirst, m_actions.stepLast,
                            m_actions.stepToBreakpoint, m_actions.stepBackToBreakpoint})
        action->setEnabled(m_stepper->active());
}

}  // namespace cullscope::ui
