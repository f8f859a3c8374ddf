#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <optional>

#include "ui/jobs/background.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Opens what the user names: a mesh, a generator, a saved session, or a picture saved by Cullscope. If that fails, nothing
/// changes, and one sentence is reported through Session::messageRaised.
class SessionOpener : public QObject {
    Q_OBJECT

public:
    enum class Kind { Session, Picture, Scene };

    SessionOpener(Session& session, CameraBookmarks& bookmarks, QObject* parent = nullptr);

    /// The kind by file name extension: `.cullscope` and `.json` are sessions, the picture formats that Cullscope writes are
    /// pictures; core opens all others and all generators.
    [[nodiscard]] static Kind kindOf(const QString& what);
    /// Lower case, without a dot.
    [[nodiscard]] static QStringList pictureExtensions();

    /// Opens in the background. A newer call, or any newer opening of a scene, replaces this one.
    void open(const QString& what);
    /// Opens the state's scene and then applies the state. `origin` is the file that the state was read from, if any.
    void restore(const SessionState& state, const QString& origin = {});

    /// Sets a function that adds to a state what the window alone knows.
    void setWindowState(std::function<void(SessionState&)> add) { m_addWindowState = std::move(add); }

    /// The present state for a session file, bookmarks included. `arrangement` is the id of the window's arrangement.
    [[nodiscard]] SessionState current(const QString& arrangement) const;
    /// Saves that state. Reports an error through the session and returns false.
    bool save(const QString& file, const QString& arrangement);

signals:
    /// A scene was opened from `what`, a file or a specification.
    void opened(const QString& what);
    /// Emitted after `opened` if a state was applied: the window restores its arrangement.
    void restored(const cullscope::ui::SessionState& state);
    /// What was to be opened could not be: its file could not be read, or the scene that it names. The sentence was reported
    /// through Session::messageRaised.
    void failed();

private:
    struct Pending {
        SessionState state;
        QString origin;
    };

    void read(const QString& file, Kind kind);
    void finish();

    Session& m_session;
    CameraBookmarks& m_bookmarks;
    Background m_reading;
    std::optional<Pending> m_pending;
    std::function<void(SessionState&)> m_addWindowState = [](SessionState&) {};
    bool m_starting = false;  ///< this object itself is starting a loading
};

}  // namespace cullscope::ui
