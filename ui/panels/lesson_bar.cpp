#include "ui/panels/lesson_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QVBoxLayout>

#include "ui/look/tinted_icon.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr int kLessonButton = 32;
constexpr int kLessonIcon = 20;
constexpr double kSentenceLarger = 1.25;  // letters of the sentence, against those of the window

}  // namespace

LessonBar::LessonBar(LessonPlayer& lessons, const Language& language, QWidget* parent)
    : QWidget(parent),
      m_lessons(lessons),
      m_language(language),
      m_title(new QLabel(this)),
      m_place(new QLabel(this)),
      m_sentence(new QLabel(this)),
      m_back(new QToolButton(this)),
      m_next(new QToolButton(this)),
      m_leave(new QToolButton(this)) {
    layOut();
    connect(m_back, &QToolButton::clicked, &lessons, &LessonPlayer::back);
    connect(m_next, &QToolButton::clicked, &lessons, &LessonPlayer::forward);
    connect(m_leave, &QToolButton::clicked, &lessons, &LessonPlayer::leave);
    connect(&lessons, &LessonPlayer::changed, this, &LessonBar::refresh);
    retranslate();
}

void LessonBar::layOut() {
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    QFont large = font();
    large.setPointSizeF(kSentenceLarger * large.pointSizeF());
    m_sentence->setFont(large);
    m_sentence->setTextFormat(Qt::PlainText);
    m_sentence->setWordWrap(true);
    m_sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    for (const auto& [button, icon] : {std::pair(m_back, "step-back"), std::pair(m_next, "step-forward")}) {
        button->setIcon(tintedIcon(QLatin1String(icon)));
        button->setIconSize({kLessonIcon, kLessonIcon});
        button->setFixedSize(kLessonButton, kLessonButton);
        button->setAutoRaise(true);
    }
    m_leave->setText(QStringLiteral("✕"));
    m_leave->setAutoRaise(true);
    m_leave->setFixedSize(kLessonButton, kLessonButton);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(m_title);
    words->addWidget(m_sentence, 1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 8, 6);
    row->addLayout(words, 1);
    for (QWidget* part : std::initializer_list<QWidget*>{m_back, m_place, m_next, m_leave}) row->addWidget(part, 0, Qt::AlignTop);
}

void LessonBar::refresh() {
    setVisible(m_lessons.active());
    if (!m_lessons.active()) return;
    const std::string language = m_language.current().toStdString();
    m_title->setText(QString::fromStdString(textIn(m_lessons.lesson().title, language)));
    m_sentence->setText(QString::fromStdString(textIn(m_lessons.current().sentence, language)));
    m_place->setText(tr("%1 of %2", "a step of a lesson, number of steps").arg(m_lessons.step() + 1).arg(m_lessons.count()));
    m_place->setMinimumHeight(kLessonButton);
    m_back->setEnabled(m_lessons.step() > 0);
    m_next->setEnabled(m_lessons.step() + 1 < m_lessons.count());
    fitHeight();
}

void LessonBar::fitHeight() {
    const int room = m_sentence->width();
    if (!m_lessons.active() || room < 1) return;
    int height = 0;
    for (const LessonStep& step : m_lessons.lesson().steps) {
        const QString sentence = QString::fromStdString(textIn(step.sentence, m_language.current().toStdString()));
        const QRect place = m_sentence->fontMetrics().boundingRect(QRect(0, 0, room, 1'000), Qt::TextWordWrap, sentence);
        height = std::max(height, place.height());
    }
    m_sentence->setFixedHeight(height + 2);
}

void LessonBar::retranslate() {
    const std::array<std::pair<QToolButton*, QString>, 3> words{{{m_back, tr("One step back (Page Up)")},
                                                                 {m_next, tr("One step on (Page Down)")},
                                                                 {m_leave, tr("Leave the lesson: what is shown stays")}}};
    for (const auto& [button, text] : words) {
        button->setToolTip(text);
        button->setAccessibleName(text);
    }
    refresh();
}

void LessonBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) retranslate();
    QWidget::changeEvent(event);
}

void LessonBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitHeight();
}

}  // namespace cullscope::ui
