#include "ui/startup/recovery.h"

#include <QCoreApplication>
#include <QStandardPaths>

#include "core/base/error.h"
#include "ui/session/session_file.h"

namespace cullscope::ui {

Recovery::Recovery(Application& application, Session& session, MainWindow& window, std::filesystem::path file)
    : QObject(&window), m_session(session), m_window(window), m_file(std::move(file)) {
    connect(&application, &Application::eventFailed, this, &Recovery::keepAndSay);
}

std::filesystem::path Recovery::usualFile() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation);
    return std::filesystem::path(folder.toStdString()) / (std::string("kept.") + kSessionExtension);
}

bool Recovery::keep() {
    if (!m_session.opened()) return false;
    try {
        std::filesystem::create_directories(m_file.parent_path());
        saveSession(m_file, m_window.document().opener().current({}));
        return true;
    } catch (const std::exception&) {
        // What led here is the failure to be told.
        return false;
    }
}

void Recovery::keepAndSay(const Message& why) {
    m_session.raise(Severity::Error,
                    {keep() ? QT_TRANSLATE_NOOP("core",
                                                "This failed, and Cullscope goes on: %1 The session is kept in a file that "
                                                "the next start offers.")
                            : QT_TRANSLATE_NOOP("core", "This failed, and Cullscope goes on: %1 Save what you need."),
                     {why.english()}});
}

void Recovery::offer() {
    std::error_code unreadable;
    if (!std::filesystem::is_regular_file(m_file, unreadable)) return;
    const auto show = [this] {
        m_window.message().offer(
            Severity::Warning,
            {QT_TRANSLATE_NOOP("core", "Something failed when Cullscope last ran. The session was kept as it was then."), {}},
            QT_TRANSLATE_NOOP("core", "Open it"), [this] { open(); });
    };
    connect(&m_window.document().opener(), &SessionOpener::opened, this, show, Qt::SingleShotConnection);
}

void Recovery::open() {
    try {
        const SessionState state = loadSession(m_file);
        const auto remove = [this, scene = state.scene](const SessionState& restored) {
            std::error_code ignored;
            if (restored.scene == scene) std::filesystem::remove(m_file, ignored);
        };
        connect(&m_window.document().opener(), &SessionOpener::restored, this, remove, Qt::SingleShotConnection);
        // Without the file's name: the session is saved under a name of the user's choice.
        m_window.document().opener().restore(state);
    } catch (const Error& failure) {
        m_session.raise(Severity::Error, failure.message());
    }
}

}  // namespace cullscope::ui
