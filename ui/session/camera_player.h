#pragma once

#include <QObject>
#include <QTimer>

#include "core/scene/camera_path.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Moves the linked views' camera along a path: at most 30 poses a second at speed 1, and the next pose only after all shown
/// views have drawn the one before. Near and far planes are set around the scene as for any camera of the desktop; those in the
/// path are for cullbench. Esc and the opening of another scene stop it; a camera moved by the user pauses it.
class CameraPlayer : public QObject {
    Q_OBJECT

public:
    explicit CameraPlayer(Session& session, QObject* parent = nullptr);

    /// Plays from the first pose. Does nothing if the path has no poses or no scene is open.
    void play(CameraPath path);
    /// The same, and stays at the first pose.
    void open(CameraPath path);
    /// Shows a pose of an active path and stays there; one beyond its ends is the first or the last.
    void go(int pose);
    void pause();
    /// Goes on from the present pose; at the end of the path, from the first.
    void resume();
    void stop();
    /// 1: 30 poses a second where drawing is that fast.
    void setSpeed(double speed);
    [[nodiscard]] double speed() const { return m_speed; }

    /// Whether a path is loaded, playing or paused.
    [[nodiscard]] bool active() const { return !m_path.poses.empty(); }
    [[nodiscard]] bool playing() const { return m_playing; }
    [[nodiscard]] int pose() const { return m_pose; }
    [[nodiscard]] const CameraPath& path() const { return m_path; }

signals:
    void poseChanged(int pose);
    /// active() or playing() changed.
    void stateChanged();
    /// The path has shown its last pose.
    void finished();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void begin(CameraPath path, bool playing);
    void show(int pose);
    void advance();
    void setPlaying(bool playing);
    [[nodiscard]] bool shown() const;

    Session& m_session;
    CameraPath m_path;
    QTimer m_pause;  ///< runs for the minimum time between two poses
    Camera m_given;  ///< the session's camera after the present pose was set
    int m_pose = 0;
    double m_speed = 1.0;
    bool m_playing = false;
    bool m_moving = false;  ///< the player itself is moving the camera
};

}  // namespace cullscope::ui
