#include "ui/panels/question_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <algorithm>
#include <array>

#include "ui/look/wheel_guard.h"
#include "ui/models/prediction_model.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

/// What an entry of the list of questions asks.
struct Entry {
    Prediction::Question question;
    std::optional<Prediction::Items> of;
};
const std::array<Entry, 4> kEntries{{{Prediction::Question::Vanish, Prediction::Items::Objects},
                                     {Prediction::Question::Vanish, Prediction::Items::Triangles},
                                     {Prediction::Question::Order, {}},
                                     {Prediction::Question::Place, {}}}};

}  // namespace

QuestionBar::QuestionBar(Session& session, QuestionFirst& questions, QWidget* parent)
    : QWidget(parent),
      m_session(session),
      m_questions(questions),
      m_question(new QComboBox(this)),
      m_words(new QLabel(this)),
      m_place(new QComboBox(this)),
      m_reveal(new QPushButton(this)),
      m_withdraw(new QPushButton(this)) {
    for (size_t entry = 0; entry < kEntries.size(); ++entry) m_question->addItem(QString());
    leaveWheelUnlessFocused(*m_question);
    leaveWheelUnlessFocused(*m_place);
    m_words->setWordWrap(true);
    // Room for two lines, so that the views keep their size from question to question.
    m_words->setMinimumHeight(2 * lineHeight(m_words->fontMetrics()));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->addWidget(m_question);
    row->addWidget(m_words, 1);
    row->addWidget(m_place);
    row->addWidget(m_reveal);
    row->addWidget(m_withdraw);
    connect(m_question, &QComboBox::activated, this,
            [this](int chosen) { m_questions.ask(kEntries[size_t(chosen)].question, kEntries[size_t(chosen)].of); });
    connect(m_place, &QComboBox::activated, this, [this](int chosen) {
        if (chosen > 0) m_questions.place(size_t(chosen - 1));
    });
    connect(m_reveal, &QPushButton::clicked, &questions, &QuestionFirst::reveal);
    connect(m_withdraw, &QPushButton::clicked, &questions, &QuestionFirst::withdraw);
    connect(&session, &Session::questionChanged, this, &QuestionBar::refresh);
    retranslate();
}

void QuestionBar::refresh() {
    const std::optional<Prediction>& question = m_session.question();
    setVisible(question.has_value());
    if (!question) return;
    m_question->setCurrentIndex(entryOf(question->question, question->of));
    m_words->setText(words());
    const bool answered = m_questions.isAnswered();
    m_reveal->setEnabled(answered);
    m_reveal->setToolTip(answered ? QString() : tr("Nothing was predicted yet: first click what you expect."));
    refreshPlaces();
}

int QuestionBar::entryOf(Prediction::Question question, Prediction::Items of) {
    const auto found = std::ranges::find_if(
        kEntries, [&](const Entry& entry) { return entry.question == question && entry.of.value_or(of) == of; });
    return int(found - kEntries.begin());
}

QString QuestionBar::askedText(const Prediction& question) {
    switch (question.question) {
        case Prediction::Question::Vanish:
            return question.of == Prediction::Items::Triangles ? tr("Which triangles vanish?") : tr("Which objects vanish?");
        case Prediction::Question::Order:
            return tr("In which order is it drawn?");
        case Prediction::Question::Place:
            return tr("In which leaf does it lie?");
    }
    return {};
}

QString QuestionBar::words(const Session& session) {
    const Prediction& question = *session.question();
    const QString named = countText(question.items.size());
    const NamedParts* parts = session.questionParts().get();
    if (question.question == Prediction::Question::Vanish)
        return tr("Click what you expect, in a view or in the tree, or drag over it with Ctrl; again takes it back. Named: %1")
            .arg(named);
    if (question.question != Prediction::Question::Place)
        return tr("Click what you expect; a second click takes it back. Named: %1").arg(named);
    if (!parts) return {};
    if (parts->places.empty() && parts->leaves > 0)
        return tr("The active view's strategy has %1 leaves here: more than %2 are not named. Choose a smaller scene or other "
                  "parameters.")
            .arg(countText(parts->leaves), countText(NamedParts::kMostLeaves));
    if (parts->places.empty())
        return tr(
            "The active view's strategy has no leaves that could be named. Choose another strategy, other parameters, or "
            "another question.");
    if (question.items.empty())
        return tr("Click a part, then choose the leaf in which it lies, here or in the tree. Named: %1").arg(named);
    return tr("In which leaf does %1 lie? Then click the next part. Named: %2")
        .arg(QString::fromStdString(parts->parts[question.items.back()].name), named);
}

void QuestionBar::refreshPlaces() {
    const Prediction& question = *m_session.question();
    const NamedParts* parts = m_session.questionParts().get();
    const bool asks = question.question == Prediction::Question::Place && parts && !parts->places.empty();
    m_place->setVisible(asks);
    if (!asks) return;
    QStringList names{QStringLiteral("–")};
    for (size_t place = 0; place < parts->places.size(); ++place) names << PredictionModel::placeName(*parts, place);
    m_place->clear();
    m_place->addItems(names);
    m_place->setEnabled(!question.items.empty());
    const std::optional<size_t> expected = question.places.empty() ? std::nullopt : question.places.back();
    m_place->setCurrentIndex(expected ? int(*expected) + 1 : 0);
}

void QuestionBar::retranslate() {
    for (int entry = 0; entry < m_question->count(); ++entry) {
        const Entry& asked = kEntries[size_t(entry)];
        m_question->setItemText(entry, askedText({asked.question, asked.of.value_or(Prediction::Items::Objects)}));
    }
    m_question->setAccessibleName(tr("Question"));
    m_place->setAccessibleName(tr("Leaf"));
    m_reveal->setText(tr("Reveal"));
    m_withdraw->setText(tr("Withdraw"));
    refresh();
}

void QuestionBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
