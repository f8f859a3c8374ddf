#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>

#include "ui/window/main_window.h"

namespace cullscope::ui {

/// Throws Error(Usage) unless the file's name ends as a picture of the window can be written: .png, .jpg or another format of
/// Qt's.
void requireWindowPictureFormat(const std::filesystem::path& file);

/// Saves one picture of the window after the scene is opened and its metrics are known, or after it could not be opened.
class WindowPicture : public QObject {
    Q_OBJECT

public:
    WindowPicture(MainWindow& window, Session& session, std::filesystem::path file, QObject* parent = nullptr);

signals:
    /// `status` is the program's exit status: 0 for success, 2 if the file cannot be written, 3 if the scene, session or
    /// picture that was named could not be opened or memory is wanting, 4 if the scene's upload to OpenGL failed.
    void done(int status);

private:
    [[nodiscard]] bool settled() const;
    void look();
    void take();

    MainWindow& m_window;
    Session& m_session;
    std::filesystem::path m_file;
    QTimer m_poll;
    bool m_failed = false;
};

}  // namespace cullscope::ui
