#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "ui/session/lesson_player.h"
#include "ui/text/language.h"

namespace cullscope::ui {

/// The bar over the views while a lesson is on: its title, the step's sentence, the number of steps, and buttons. Hidden without
/// a lesson.
class LessonBar : public QWidget {
    Q_OBJECT

public:
    LessonBar(LessonPlayer& lessons, const Language& language, QWidget* parent = nullptr);

    [[nodiscard]] QString sentence() const { return m_sentence->text(); }
    [[nodiscard]] QString place() const { return m_place->text(); }
    [[nodiscard]] QToolButton& nextButton() { return *m_next; }
    [[nodiscard]] QToolButton& backButton() { return *m_back; }
    [[nodiscard]] QToolButton& leaveButton() { return *m_leave; }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void refresh();
    void retranslate();
    /// As high as the longest sentence of the lesson needs, so that the views keep their size from step to step.
    void fitHeight();

    LessonPlayer& m_lessons;
    const Language& m_language;
    QLabel *m_title, *m_place, *m_sentence;
    QToolButton *m_back, *m_next, *m_leave;
};

}  // namespace cullscope::ui
