#pragma once

#include <QObject>
#include <QTimer>

#include "core/scene/camera_path.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Leads the linked views' camera along a path, at most 30 poses a second at speed 1 and none before all shown views have drawn
/// the one before, so that each pose is seen. Near and far are set around the scene as for any camera of the desktop; the
/// path's are for cullbench. Esc stops, and so does another scene; a camera moved by hand pauses.
class CameraPlayer : public QObject {
    Q_OBJECT

public:
    explicit CameraPlayer(Session& session, QObject* parent = nullptr);

    /// Plays from the first pose. A path without poses, or no scene: nothing happens.
    void play(CameraPath path);
    void pause();
    /// Goes on from the present pose; at the end of the path, from the first.
    void resume();
    void stop();
    /// 1: 30 poses a second where drawing is that fast.
    void setSpeed(double speed);
    [[nodiscard]] double speed() const { return m_speed; }

    /// Whether there is a path, played or paused.
    [[nodiscard]] bool active() const { return !m_path.poses.empty(); }
    [[nodiscard]] bool playing() const { return m_playing; }
    [[nodiscard]] int pose() const { return m_pose; }
    [[nodiscard]] const CameraPath& path() const { return m_path; }

signals:
    void poseChanged(int pose);
    /// active(), playing()
    void stateChanged();
    /// The path has shown its last pose.
    void finished();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(int pose);
    void advance();
    void setPlaying(bool playing);
    [[nodiscard]] bool shown() const;

    Session& m_session;
    CameraPath m_path;
    QTimer m_pause;  ///< the least time between two poses
    Camera m_given;  ///< what the session made of the present pose
    int m_pose = 0;
    double m_speed = 1.0;
    bool m_playing = false;
    bool m_moving = false;  ///< the camera moves by us
};

}  // namespace cullscope::ui
