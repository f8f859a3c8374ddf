#pragma once

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "ui/session/question_first.h"

namespace cullscope::ui {

/// The bar under the views while a question is open: which question, how many were named, where the last one is expected, and
/// the buttons that reveal the answer or withdraw the question.
class QuestionBar : public QWidget {
    Q_OBJECT

public:
    QuestionBar(Session& session, QuestionFirst& questions, QWidget* parent = nullptr);

    [[nodiscard]] QComboBox& question() { return *m_question; }
    /// The entry of that list which asks about such items.
    [[nodiscard]] static int entryOf(Prediction::Question question, Prediction::Items of);
    /// The places of a question about them, after an entry without a place.
    [[nodiscard]] QComboBox& place() { return *m_place; }
    /// What is asked: "Which objects vanish?", in the user's language.
    [[nodiscard]] static QString askedText(const Prediction& question);
    /// What is to be done; only while the session has a question.
    [[nodiscard]] static QString words(const Session& session);
    [[nodiscard]] QString words() const { return words(m_session); }
    [[nodiscard]] QPushButton& revealButton() { return *m_reveal; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void refreshPlaces();
    void retranslate();

    Session& m_session;
    QuestionFirst& m_questions;
    QComboBox* m_question;
    QLabel* m_words;
    QComboBox* m_place;
    QPushButton *m_reveal, *m_withdraw;
};

}  // namespace cullscope::ui
