#pragma once

#include <QObject>

#include "ui/session/question_first.h"
#include "ui/session/stepper.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands that step through a view's frame, and those that ask about it before it is shown.
class StepCommands : public QObject {
    Q_OBJECT

public:
    StepCommands(Session& session, WindowActions& actions, QWidget* window);

    [[nodiscard]] Stepper& stepper() { return *m_stepper; }
    [[nodiscard]] QuestionFirst& questions() { return *m_questions; }

private:
    void refresh();
    void showAnswer(const Prediction& prediction, const std::vector<PredictionRow>& rows, const NamedPartsPointer& parts);

    Session& m_session;
    WindowActions& m_actions;
    QWidget* m_window;
    Stepper* m_stepper;
    QuestionFirst* m_questions;
};

}  // namespace cullscope::ui
