#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <memory>

#include "ui/jobs/gpu_jobs.h"

namespace cullscope::ui {

/// Brings a scene to OpenGL on the GPU thread, as buffer objects and, where a view asks for it, as client arrays. A scene of
/// the same meshes as the one before shares its buffers. After the loss of the thread's context it is uploaded again; until that
/// is there the old buffers stay, which nobody draws any more but by which pictures and figures know what they are of.
class SceneUpload : public QObject {
    Q_OBJECT

public:
    /// Runs on the GPU thread; `before` (may be null) holds the meshes of the scene before.
    using Uploader = std::function<SceneBuffersPointer(GpuThread&, const ScenePointer&)>;

    SceneUpload(GpuThread& gpu, Uploader uploader, QObject* parent = nullptr);

    void setScene(const ScenePointer& scene);
    /// Uploads in that way too, unless that is done or under way.
    void want(Upload upload);
    [[nodiscard]] const SceneBuffersPointer& buffers(Upload upload) const { return m_ways[size_t(upload)].buffers; }
    /// Why OpenGL did not take the scene; empty: it did, or it is on its way.
    [[nodiscard]] const Message& failure() const { return m_failure; }

signals:
    void changed();
    /// Before `changed`: the same scene in a new context.
    void renewed(const cullscope::ui::SceneBuffersPointer& before, const cullscope::ui::SceneBuffersPointer& now);
    void failed(const cullscope::Message& message);

private:
    struct Way {
        SceneBuffersPointer buffers;
        bool begun = false;
    };

    void contextLost(bool replaced);
    void take(Upload upload, const SceneBuffersPointer& buffers, const Message& failure);
    void post(Upload upload, const SceneBuffersPointer& before);
    [[nodiscard]] SceneBuffersPointer make(const ScenePointer& scene, Upload upload, const SceneBuffersPointer& before) const;

    GpuThread& m_gpu;
    Uploader m_uploader;
    ScenePointer m_scene;
    std::array<Way, 2> m_ways;
    Message m_failure;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
