#pragma once

#include <QObject>
#include <filesystem>

#include "ui/startup/application.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// Keeps the session in a file when the handler of an event fails, and offers it at the next start.
class Recovery : public QObject {
    Q_OBJECT

public:
    /// `file` is where the session is kept (usualFile).
    Recovery(Application& application, Session& session, MainWindow& window, std::filesystem::path file);

    /// In the folder of this user's data that the program makes itself.
    [[nodiscard]] static std::filesystem::path usualFile();

    /// Where a session was kept: once the next scene is opened, the message bar says so with a button that opens the session. The
    /// file is removed when it was restored; until then every start offers it.
    void offer();

    /// Keeps the session as it is now; returns whether it could.
    bool keep();

private:
    void keepAndSay(const Message& why);
    void open();

    Session& m_session;
    MainWindow& m_window;
    std::filesystem::path m_file;
};

}  // namespace cullscope::ui
