#pragma once

#include <QObject>
#include <QSettings>

#include "ui/dialogs/screenshot_taker.h"
#include "ui/session/camera_bookmarks.h"
#include "ui/session/recent_files.h"
#include "ui/session/session_opener.h"
#include "ui/session/undo_recorder.h"
#include "ui/views/view_grid.h"
#include "ui/window/window_actions.h"

namespace cullscope::ui {

/// Commands for the document as a whole: open, recent files, sessions, screenshots, undo, camera bookmarks.
class DocumentCommands : public QObject {
    Q_OBJECT

public:
    DocumentCommands(Session& session, ViewGrid& views, WindowActions& actions, QWidget* window);

    [[nodiscard]] SessionOpener& opener() { return *m_opener; }
    [[nodiscard]] UndoRecorder& undo() { return *m_undo; }
    [[nodiscard]] ScreenshotTaker& screenshots() { return *m_screenshots; }
    /// Sets the function that returns the id of the window's arrangement, which is saved with sessions.
    void setArrangement(std::function<QString()> arrangement) { m_arrangement = std::move(arrangement); }
    void openByDialog();
    void retranslate();
    /// The file types of the Open dialog, in the syntax of QFileDialog.
    [[nodiscard]] static QString fileTypes();

private:
    void wire();
    void fillRecent();
    void fillBookmarks();
    void keepBookmark(int place);
    void nameBookmark(int place);
    void showUndo();
    void save(bool askWhere);

    Session& m_session;
    WindowActions& m_actions;
    QWidget* m_window;
    CameraBookmarks m_bookmarks;
    RecentFiles m_recent;
    SessionOpener* m_opener;
    UndoRecorder* m_undo;
    ScreenshotTaker* m_screenshots;
    std::function<QString()> m_arrangement = [] { return QString(); };
    QString m_file;  ///< path of the session file; empty: none yet
    QSettings m_settings;
};

}  // namespace cullscope::ui
