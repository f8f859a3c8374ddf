#pragma once

#include <QObject>
#include <QString>
#include <optional>

#include "core/scene/camera_path.h"
#include "ui/jobs/background.h"
#include "ui/session/camera_player.h"
#include "ui/session/camera_recorder.h"

namespace cullscope::ui {

/// The camera path in hand: recorded, opened from a file or built in, and what can be done with it. It is played and stepped
/// without measuring anything.
class PathDesk : public QObject {
    Q_OBJECT

public:
    explicit PathDesk(Session& session, QObject* parent = nullptr);

    [[nodiscard]] CameraRecorder& recorder() { return *m_recorder; }
    [[nodiscard]] CameraPlayer& player() { return *m_player; }
    /// The path in hand, while one is recorded as far as it goes; without poses: there is none.
    [[nodiscard]] const CameraPath& path() const { return m_recorder->recording() ? m_recorder->path() : m_path; }
    /// Whether the path in hand is the user's own: recorded or changed here.
    [[nodiscard]] bool own() const { return m_own; }
    /// The built-in path that is being made; empty: none.
    [[nodiscard]] const QString& making() const { return m_making; }

    /// Takes up a built-in path, such as "tour:16", and shows its first pose. Large scenes take seconds: it is made beside the
    /// window.
    void makeBuiltIn(const QString& name);
    /// Takes up a path from a file, and plays it. Throws what readCameraPath throws.
    void open(const std::filesystem::path& file);
    /// Writes the path in hand, which has the file's name from then on. Throws Error(Usage) where it has no poses or cannot be
    /// written.
    void save(const std::filesystem::path& file);

    /// Plays the path in hand, or goes on.
    void play();
    /// Shows a pose and stays there.
    void go(int pose);
    void step(int by);
    /// Ends recording, making and playing, and puts the path away from the window; it stays in hand.
    void stop();

    /// Leaves the poses before the present one out, or those after it.
    void beginHere();
    void endHere();
    void smooth();
    void rename(const QString& name);

signals:
    /// Anything of the above changed.
    void changed();
    /// The user's own path is this one from now on; without poses: there is none.
    void ownPathChanged(const cullscope::CameraPath& path);

private:
    void take(CameraPath path, bool own);
    void takeRecorded();
    void edit(CameraPath path, int pose);
    void playFromStart();

    Session& m_session;
    CameraRecorder* m_recorder;
    CameraPlayer* m_player;
    Background m_background;
    CameraPath m_path;
    QString m_making;
    bool m_own = false;
    bool m_recording = false;
};

}  // namespace cullscope::ui
