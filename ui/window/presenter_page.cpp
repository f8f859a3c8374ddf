#include "ui/window/presenter_page.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLocale>
#include <QTime>
#include <QVBoxLayout>

namespace cullscope::ui {

namespace {

constexpr double kClockLarger = 2.2;  // letters against those of the window
constexpr double kPresenterSentence = 1.6;
constexpr double kNotesLarger = 1.3;
constexpr int kEverySecond = 1'000;  // ms
constexpr int kPresenterMargin = 32;

QLabel* largeLabel(QWidget* parent, double larger, bool bold = false) {
    auto* label = new QLabel(parent);
    QFont font = label->font();
    font.setPointSizeF(larger * font.pointSizeF());
    font.setBold(bold);
    label->setFont(font);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

PresenterPage::PresenterPage(LessonPlayer& lessons, const Language& language, QWidget* parent)
    : QWidget(parent),
      m_lessons(lessons),
      m_language(language),
      m_clock(largeLabel(this, kClockLarger, true)),
      m_place(largeLabel(this, kPresenterSentence)),
      m_nowTitle(largeLabel(this, 1.0, true)),
      m_now(largeLabel(this, kPresenterSentence)),
      m_notes(largeLabel(this, kNotesLarger)),
      m_nextTitle(largeLabel(this, 1.0, true)),
      m_next(largeLabel(this, kPresenterSentence)) {
    m_place->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* head = new QHBoxLayout;
    head->addWidget(m_clock, 1);
    head->addWidget(m_place, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kPresenterMargin, kPresenterMargin, kPresenterMargin, kPresenterMargin);
    layout->setSpacing(kPresenterMargin / 4);
    layout->addLayout(head);
    layout->addSpacing(kPresenterMargin / 2);
    for (QWidget* part : std::initializer_list<QWidget*>{m_nowTitle, m_now, m_notes}) layout->addWidget(part);
    layout->addSpacing(kPresenterMargin / 2);
    for (QWidget* part : std::initializer_list<QWidget*>{m_nextTitle, m_next}) layout->addWidget(part);
    layout->addStretch(1);
    m_tick.setInterval(kEverySecond);
    connect(&m_tick, &QTimer::timeout, this, &PresenterPage::showTime);
    connect(&lessons, &LessonPlayer::changed, this, &PresenterPage::refresh);
    refresh();
}

void PresenterPage::begin() {
    m_since.start();
    m_tick.start();
    showTime();
    refresh();
}

void PresenterPage::showTime() {
    const QTime since = QTime(0, 0).addMSecs(int(m_since.isValid() ? m_since.elapsed() : 0));
    m_clock->setText(tr("%1 · %2 since the beginning", "time of day, duration")
                         .arg(QLocale().toString(QTime::currentTime(), QLocale::ShortFormat),
                              since.toString(since.hour() > 0 ? QStringLiteral("h:mm:ss") : QStringLiteral("m:ss"))));
}

void PresenterPage::refresh() {
    const std::string language = m_language.current().toStdString();
    const auto in = [&](const LessonText& text) { return QString::fromStdString(textIn(text, language)); };
    const bool on = m_lessons.active();
    const bool more = on && m_lessons.step() + 1 < m_lessons.count();
    m_nowTitle->setText(tr("Now"));
    m_nextTitle->setText(tr("Next"));
    m_place->setText(on ? tr("%1 of %2", "a step of a lesson, number of steps").arg(m_lessons.step() + 1).arg(m_lessons.count())
                        : QString());
    m_now->setText(
        on ? in(m_lessons.current().sentence)
           : tr("The lecture shows the views. Page Down goes on, R shows the figures, B blanks the screen, P points."));
    m_notes->setText(on ? in(m_lessons.current().notes) : QString());
    m_notes->setVisible(!m_notes->text().isEmpty());
    m_next->setText(more ? in(m_lessons.lesson().steps[size_t(m_lessons.step()) + 1].sentence)
                    : on ? tr("This is the last step.")
                         : QString());
    m_nextTitle->setVisible(on);
}

void PresenterPage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) refresh();
    QWidget::changeEvent(event);
}

}  // namespace cullscope::ui
