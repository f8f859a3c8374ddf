#pragma once

#include <QObject>
#include <QTimer>
#include <filesystem>

#include "core/scene/camera_path.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// Records where the linked views' camera goes, as a camera path: while it runs, at most 30 poses a second and always the last
/// one; beside that, single poses on demand. A path has one lens for all poses: its field of view is that of the first pose, its
/// near and far distances take in those of all poses.
class CameraRecorder : public QObject {
    Q_OBJECT

public:
    explicit CameraRecorder(Session& session, QObject* parent = nullptr);

    /// Begins a new path with the camera as it stands.
    void start();
    /// Ends with the camera as it stands; another scene does that too. The path stays until a new one is begun.
    void stop();
    [[nodiscard]] bool recording() const { return m_recording; }
    /// Adds the camera as it stands to the path; with or without a recording under way.
    void addPose();
    /// Forgets the path and ends the recording.
    void clear();

    [[nodiscard]] const CameraPath& path() const { return m_path; }
    /// Whether a pose had another field of view than the first one.
    [[nodiscard]] bool lensDiffers() const { return m_lensDiffers; }
    /// Throws Error(Usage) where there is no pose yet or the place cannot be written.
    void save(const std::filesystem::path& file) const;

signals:
    /// Path or recording().
    void changed();

private:
    void cameraMoved();
    void add(const Camera& camera);
    void end();

    Session& m_session;
    CameraPath m_path;
    OpenedScenePointer m_scene;  ///< that is recorded
    Camera m_last;               ///< the newest camera of the recording, added or not
    QTimer m_pause;              ///< until the next pose may be added
    bool m_recording = false;
    bool m_lensDiffers = false;
};

}  // namespace cullscope::ui
