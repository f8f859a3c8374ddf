#pragma once

#include <QObject>
#include <QString>
#include <QTimer>

#include "ui/window/main_window.h"

namespace cullscope::ui {

/// Takes one picture of the window once the scene is there and its figures are known, and tells how it went.
class WindowPicture : public QObject {
    Q_OBJECT

public:
    WindowPicture(MainWindow& window, Session& session, QString file, QObject* parent = nullptr);

signals:
    /// `status` is the program's exit status: 0, 2 where the file cannot be written, 3 where the scene could not be opened,
    /// 4 where OpenGL did not take it.
    void done(int status);

private:
    [[nodiscard]] bool settled() const;
    void look();
    void take();

    MainWindow& m_window;
    Session& m_session;
    QString m_file;
    QTimer m_poll;
    bool m_failed = false;
};

}  // namespace cullscope::ui
