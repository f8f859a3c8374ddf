#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>

#include "core/scene/camera_path.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Records the linked views' camera as a camera path: at most 30 poses a second, and always the last one; single poses can be
/// added at any time. A path has one lens for all poses: the field of view of the first pose, and near and far distances that
/// cover those of all poses.
class CameraRecorder : public QObject {
    Q_OBJECT

public:
    explicit CameraRecorder(Session& session, QObject* parent = nullptr);

    /// Begins a new path with the present camera.
    void start();
    /// Adds the present camera and ends the recording; the opening of another scene ends it too. The path is kept until a new one
    /// begins.
    void stop();
    [[nodiscard]] bool recording() const { return m_recording; }
    /// Adds the present camera to the path, recording or not.
    void addPose();
    /// Deletes the path and ends the recording.
    void clear();
    /// Replaces the path by a changed one, to which poses can be added; only while none is recorded.
    void replace(CameraPath path);

    [[nodiscard]] const CameraPath& path() const { return m_path; }
    /// Whether the field of view of a pose differed from that of the first pose.
    [[nodiscard]] bool lensDiffers() const { return m_lensDiffers; }
    /// Writes the path. Throws Error(Usage) if it has no poses or the file cannot be written.
    void save(const std::filesystem::path& file) const;

signals:
    /// path() or recording() changed.
    void changed();

private:
    void cameraMoved();
    void add(const Camera& camera);
    void end();

    Session& m_session;
    CameraPath m_path;
    OpenedScenePointer m_scene;  ///< the scene in which the recording began
    Camera m_last;               ///< newest camera of the recording, added to the path or not
    QTimer m_pause;              ///< runs until the next pose may be added
    bool m_recording = false;
    bool m_lensDiffers = false;
};

}  // namespace cullscope::ui
