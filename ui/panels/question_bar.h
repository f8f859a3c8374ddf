#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "ui/session/question_first.h"

namespace cullscope::ui {

/// The bar under the views while a question is open: which question, how many were named, and the buttons that reveal the answer
/// or withdraw the question.
class QuestionBar : public QWidget {
    Q_OBJECT

public:
    QuestionBar(Session& session, QuestionFirst& questions, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& question() { return *m_question; }
    [[nodiscard]] QPushButton& revealButton() { return *m_reveal; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void retranslate();

    Session& m_session;
    QuestionFirst& m_questions;
    QComboBox* m_question;
    QLabel* m_words;
    QPushButton *m_reveal, *m_withdraw;
};

}  // namespace cullscope::ui
