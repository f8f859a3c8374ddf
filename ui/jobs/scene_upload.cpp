#include "ui/jobs/scene_upload.h"

#include <QCoreApplication>

#include "core/base/error.h"

namespace cullscope::ui {

SceneUpload::SceneUpload(GpuThread& gpu, Uploader uploader, QObject* parent)
    : QObject(parent), m_gpu(gpu), m_uploader(std::move(uploader)) {
    connect(&gpu, &GpuThread::contextLost, this, &SceneUpload::contextLost);
}

void SceneUpload::setScene(const ScenePointer& scene) {
    const bool sameMeshes = m_scene && scene && m_scene->meshes() == scene->meshes();
    const std::array<Way, 2> before = m_ways;
    m_jobs.cancel();
    m_scene = scene;
    m_ways = {};
    m_failure = {};
    if (!scene) return;
    for (const Upload upload : {Upload::Vbo, Upload::VertexArray}) {
        if (!before[size_t(upload)].begun && upload != Upload::Vbo) continue;
        m_ways[size_t(upload)].begun = true;
        post(upload, sameMeshes ? before[size_t(upload)].buffers : nullptr);
    }
}

void SceneUpload::want(Upload upload) {
    if (!m_scene || std::exchange(m_ways[size_t(upload)].begun, true)) return;
    post(upload, nullptr);
}

SceneBuffersPointer SceneUpload::make(const ScenePointer& scene, Upload upload, const SceneBuffersPointer& before) const {
    if (before && m_gpu.holds(before)) return m_gpu.share(scene, *before);
    return upload == Upload::Vbo && m_uploader ? m_uploader(m_gpu, scene) : m_gpu.upload(scene, upload);
}

void SceneUpload::post(Upload upload, const SceneBuffersPointer& before) {
    m_jobs.add(m_gpu, [this, scene = m_scene, upload, before](GpuJobs::Step& step) {
        SceneBuffersPointer buffers;
        Message failure;
        try {
            buffers = make(scene, upload, before);
        } catch (const std::exception& error) {
            failure = sentenceOf(error, QT_TRANSLATE_NOOP("core", "The scene cannot be given to OpenGL: %1"));
        }
        // Uploaded into nothing: it begins anew as soon as the loss is known here.
        if (!m_gpu.losing()) step.deliver([this, upload, buffers, failure] { take(upload, buffers, failure); });
    });
}

void SceneUpload::take(Upload upload, const SceneBuffersPointer& buffers, const Message& failure) {
    const SceneBuffersPointer before = std::exchange(m_ways[size_t(upload)].buffers, buffers);
    const bool news = !failure.empty() && failure.english() != m_failure.english();
    if (!failure.empty()) m_failure = failure;
    if (before && buffers) emit renewed(before, buffers);
    emit changed();
    // Both ways of uploading may fail for the same reason: report it once.
    if (news) emit failed(failure);
}

void SceneUpload::contextLost(bool replaced) {
    if (!m_scene) return;
    m_jobs.cancel();
    if (!replaced) {
        m_failure = lossMessage(false);
        emit changed();
        return;
    }
    m_failure = {};
    for (const Upload upload : {Upload::Vbo, Upload::VertexArray})
        if (m_ways[size_t(upload)].begun) post(upload, nullptr);
}

}  // namespace cullscope::ui
