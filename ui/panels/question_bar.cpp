#include "ui/panels/question_bar.h"

#include <QEvent>
#include <QHBoxLayout>

#include "ui/look/wheel_guard.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

QuestionBar::QuestionBar(Session& session, QuestionFirst& questions, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_questions(questions),
      m_question(new QComboBox(this)),
      m_words(new QLabel(this)),
      m_reveal(new QPushButton(this)),
      m_withdraw(new QPushButton(this)) {
    m_question->addItems({QString(), QString()});
    leaveWheelUnlessFocused(*m_question);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(m_question);
    row->addWidget(m_words, 1);
    row->addWidget(m_reveal);
    row->addWidget(m_withdraw);
    connect(m_question, &QComboBox::activated, this, [this](int chosen) { m_questions.ask(Prediction::Question(chosen)); });
    connect(m_reveal, &QPushButton::clicked, &questions, &QuestionFirst::reveal);
    connect(m_withdraw, &QPushButton::clicked, &questions, &QuestionFirst::withdraw);
    connect(&session, &Session::questionChanged, this, &QuestionBar::refresh);
    retranslate();
}

void QuestionBar::refresh() {
    const std::optional<Prediction>& question = m_session.question();
    setVisible(question.has_value());
    if (!question) return;
    m_question->setCurrentIndex(int(question->question));
    m_words->setText(tr("Click what you expect; a second click takes it back. Named: %1").arg(countText(question->items.size())));
}

void QuestionBar::retranslate() {
    m_question->setItemText(int(Prediction::Question::Vanish), tr("What vanishes?"));
    m_question->setItemText(int(Prediction::Question::Order), tr("In which order is it drawn?"));
    m_question->setAccessibleName(tr("Question"));
    m_reveal->setText(tr("Reveal"));
    m_withdraw->setText(tr("Withdraw"));
    refresh();
}

void QuestionBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
