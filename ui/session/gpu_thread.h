#pragma once

#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>

#include "core/gpu/context.h"
#include "core/gpu/scene_buffers.h"

namespace cullscope::ui {

using SceneBuffersPointer = std::shared_ptr<const SceneBuffers>;

/// What goes first on the GPU thread.
enum class Urgency {
    Picture,  ///< somebody is waiting for it: goes before everything that has not begun
    Work      ///< uploads and measurements, in the order of posting
};

/// A thread with an OpenGL context of its own in the desktop's share group: draws, uploads scenes and measures, so that
/// none of them stops the window. Made, asked and destroyed on the window's thread; needs Qt::AA_ShareOpenGLContexts.
class GpuThread {
public:
    /// Throws Error(OpenGl) where there is no OpenGL 4.5.
    GpuThread();
    /// Finishes what was posted.
    ~GpuThread();
    GpuThread(const GpuThread&) = delete;
    GpuThread& operator=(const GpuThread&) = delete;

    /// Runs `work` on the thread with the context current.
    void post(std::function<void()> work, Urgency urgency = Urgency::Work);
    /// Runs `work` there and waits for it and for everything that was posted before.
    void run(const std::function<void()>& work);

    /// Uploads a scene (on the thread: call from posted work only). The buffers are freed on the thread, whoever lets go of them;
    /// those that outlive this object went with its context.
    [[nodiscard]] SceneBuffersPointer upload(const ScenePointer& scene, Upload upload = Upload::Vbo);
    /// The same for a scene of the very meshes that `uploaded` holds: nothing is uploaded again.
    [[nodiscard]] SceneBuffersPointer share(const ScenePointer& scene, const SceneBuffers& uploaded);

    [[nodiscard]] const GlInfo& info() const { return m_info; }

private:
    /// Outlives the thread, for what is freed late.
    struct Mailbox {
        std::mutex mutex;
        QObject* worker = nullptr;  ///< null: the thread is gone
    };

    using Queue = std::deque<std::function<void()>>;

    void runNext();
    [[nodiscard]] SceneBuffersPointer ownedByThread(std::unique_ptr<SceneBuffers> buffers);

    QOffscreenSurface m_surface;
    std::unique_ptr<QOpenGLContext> m_context;
    std::mutex m_queueMutex;
    Queue m_pictures, m_work;
    QThread m_thread;
    QObject m_worker;
    std::shared_ptr<Mailbox> m_mailbox = std::make_shared<Mailbox>();
    GlInfo m_info;
};

}  // namespace cullscope::ui
