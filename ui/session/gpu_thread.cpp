#include "ui/session/gpu_thread.h"

#include "core/base/error.h"
#include "core/gpu/renderer.h"

namespace cullscope::ui {

GpuThread::GpuThread() : m_context(std::make_unique<QOpenGLContext>()) {
    m_surface.setFormat(QSurfaceFormat::defaultFormat());
    m_surface.create();
    m_context->setFormat(QSurfaceFormat::defaultFormat());
    m_context->setShareContext(QOpenGLContext::globalShareContext());
    if (!m_context->create() || !m_surface.isValid())
        throwOpenGl(
            QT_TRANSLATE_NOOP("core", "No OpenGL context can be made on this display. Install a graphics driver or Mesa."));
    m_context->moveToThread(&m_thread);
    m_worker.moveToThread(&m_thread);
    m_mailbox->worker = &m_worker;
    m_thread.setObjectName(QStringLiteral("cullscope-gpu"));
    m_thread.start();
    std::exception_ptr failure;
    run([&] {
        try {
            if (!m_context->makeCurrent(&m_surface))
                throwOpenGl(
                    QT_TRANSLATE_NOOP("core", "The OpenGL context cannot be used on this display. Update the graphics driver."));
            m_info = requireOpenGl45();
        } catch (...) {
            failure = std::current_exception();
        }
    });
    if (!failure) return;
    run([this] { m_context.reset(); });
    m_thread.quit();
    m_thread.wait();
    std::rethrow_exception(failure);
}

GpuThread::~GpuThread() {
    {
        const std::lock_guard lock(m_mailbox->mutex);
        m_mailbox->worker = nullptr;
    }
    run([this] {
        m_context->doneCurrent();
        m_context.reset();
        m_worker.moveToThread(QCoreApplication::instance()->thread());
    });
    m_thread.quit();
    m_thread.wait();
}

void GpuThread::post(std::function<void()> work, Urgency urgency) {
    {
        const std::lock_guard lock(m_queueMutex);
        (urgency == Urgency::Picture ? m_pictures : m_work).push_back(std::move(work));
    }
    // One call for each piece of work; which piece it takes is decided when it comes to it.
    QMetaObject::invokeMethod(
        &m_worker, [this] { runNext(); }, Qt::QueuedConnection);
}

void GpuThread::runNext() {
    std::function<void()> work;
    {
        const std::lock_guard lock(m_queueMutex);
        Queue& queue = m_pictures.empty() ? m_work : m_pictures;
        work = std::move(queue.front());
        queue.pop_front();
    }
    work();
}

void GpuThread::run(const std::function<void()>& work) {
    QMetaObject::invokeMethod(&m_worker, work, Qt::BlockingQueuedConnection);
}

SceneBuffersPointer GpuThread::upload(const ScenePointer& scene, Upload upload) {
    return ownedByThread(std::make_unique<SceneBuffers>(scene, upload));
}

SceneBuffersPointer GpuThread::share(const ScenePointer& scene, const SceneBuffers& uploaded) {
    return ownedByThread(std::make_unique<SceneBuffers>(scene, uploaded));
}

SceneBuffersPointer GpuThread::ownedByThread(std::unique_ptr<SceneBuffers> buffers) {
    // Other contexts of the share group see the data only once it has arrived.
    waitForGpu();
    return {buffers.release(), [mailbox = m_mailbox](SceneBuffers* freed) {
                const std::lock_guard lock(mailbox->mutex);
                // Without the thread there is no context in which to free them: OpenGL has freed its part, ours ends with the
                // process.
                if (mailbox->worker)
                    QMetaObject::invokeMethod(
                        mailbox->worker, [freed] { delete freed; }, Qt::QueuedConnection);
            }};
}

}  // namespace cullscope::ui
