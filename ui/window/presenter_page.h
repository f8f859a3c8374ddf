#pragma once

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QWidget>

#include "ui/session/lesson_player.h"
#include "ui/text/language.h"

namespace cullscope::ui {

/// What the presenter sees in the main window while the lecture is on: the clock and the time since the beginning, the sentence
/// in hand with its notes, and the next step's sentence.
class PresenterPage : public QWidget {
    Q_OBJECT

public:
    PresenterPage(LessonPlayer& lessons, const Language& language, QWidget* parent = nullptr);

    /// Begins to count the time.
    void begin();
    [[nodiscard]] QString now() const { return m_now->text(); }
    [[nodiscard]] QString notes() const { return m_notes->text(); }
    [[nodiscard]] QString next() const { return m_next->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void showTime();

    LessonPlayer& m_lessons;
    const Language& m_language;
    QLabel *m_clock, *m_place, *m_nowTitle, *m_now, *m_notes, *m_nextTitle, *m_next;
    QTimer m_tick;
    QElapsedTimer m_since;
};

}  // namespace cullscope::ui
