#pragma once

#include <QObject>
#include <QSettings>

#include "ui/session/lesson_player.h"
#include "ui/session/stepper.h"
#include "ui/text/language.h"
#include "ui/views/view_grid.h"
#include "ui/window/document_commands.h"
#include "ui/window/lesson_handout.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// The commands of lessons: the menu that lists them, walking through one, and adding what the window shows to one.
class LessonCommands : public QObject {
    Q_OBJECT

public:
    LessonCommands(Session& session, ViewGrid& views, WindowActions& actions, DocumentCommands& document,
                   const Language& language, QWidget* window);

    [[nodiscard]] LessonPlayer& player() { return *m_player; }
    [[nodiscard]] LessonHandout& handout() { return *m_handout; }
    /// Adds what the window shows as a step to a lesson's file, which is made where there is none. Raises an error where that
    /// fails, and returns false.
    bool addStep(const QString& file, const QString& sentence);
    void retranslate();

private:
    void wire();
    void fillMenu();
    void openByDialog();
    void addByDialog();
    void makeHandout();
    void refresh();

    Session& m_session;
    WindowActions& m_actions;
    DocumentCommands& m_document;
    const Language& m_language;
    QWidget* m_window;
    LessonPlayer* m_player;
    LessonHandout* m_handout;
    QSettings m_settings;
};

}  // namespace cullscope::ui
