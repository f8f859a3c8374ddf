#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "ui/jobs/background.h"
#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Opens whatever the user names: a mesh, a generator, a saved session, or a picture that Cullscope saved. What cannot be
/// opened leaves everything as it was and is said in one sentence through Session::messageRaised.
class SessionOpener : public QObject {
    Q_OBJECT

public:
    enum class Kind { Session, Picture, Scene };

    SessionOpener(Session& session, CameraBookmarks& bookmarks, QObject* parent = nullptr);

    /// By the file's type: `.cullscope` and `.json` are sessions, what OpenImageIO writes here is a picture; all else, and all
    /// generators, are left to core.
    [[nodiscard]] static Kind kindOf(const QString& what);

    /// Reads beside the window. A newer one, of any kind, takes the place of this one.
    void open(const QString& what);
    /// Opens the state's scene and gives it the state when it is there. `origin` is the file that the state is from, if any.
    void restore(const SessionState& state, const QString& origin = {});

    /// What a session file is to hold now, bookmarks included. `arrangement` is the window's id for it.
    [[nodiscard]] SessionState current(const QString& arrangement) const;
    /// Saves that; what goes wrong is raised, and false returned.
    bool save(const QString& file, const QString& arrangement);

signals:
    /// A scene is on show: the file or specification that was asked for.
    void opened(const QString& what);
    /// After `opened`, where a state came with it: the window takes its arrangement from it.
    void restored(const cullscope::ui::SessionState& state);

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
    bool m_starting = false;  ///< the loading that begins now is ours
};

}  // namespace cullscope::ui
