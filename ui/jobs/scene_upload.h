#pragma once

#include <QObject>
#include <array>
#include <functional>
#include <memory>

#include "ui/jobs/gpu_jobs.h"

namespace cullscope::ui {

/// Uploads a scene on the GPU thread: as buffer objects, and as client-side vertex arrays if a view uses them. A scene of the
/// same meshes as the one before shares its buffers. After a context loss the scene is uploaded again. Until that is done,
/// buffers() returns the old buffers: they are not drawn any more, but pictures and metrics still compare them with the buffers
/// that they were made from.
class SceneUpload : public QObject {
    Q_OBJECT

public:
    /// Uploads a scene; runs on the GPU thread.
    using Uploader = std::function<SceneBuffersPointer(GpuThread&, const ScenePointer&)>;

    SceneUpload(GpuThread& gpu, Uploader uploader, QObject* parent = nullptr);

    void setScene(const ScenePointer& scene);
    /// Uploads the scene in this way too, unless that is done or in progress.
    void want(Upload upload);
    [[nodiscard]] const SceneBuffersPointer& buffers(Upload upload) const { return m_ways[size_t(upload)].buffers; }
    /// Why the upload of the scene failed; empty: it succeeded or is in progress.
    [[nodiscard]] const Message& failure() const { return m_failure; }

signals:
    void changed();
    /// Emitted before `changed`: `now` holds the same scene as `before`, uploaded to a new context.
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
