#include "ui/jobs/gpu_thread.h"

#include <QCoreApplication>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

// Stops the replacement of contexts if a scene resets the driver each time it is drawn.
constexpr int kMostLossesInARow = 4;
constexpr qint64 kCalm = 30'000;  // ms without a loss, after which the count of losses starts again

constexpr int kTries = 5;
constexpr unsigned long kPauseBetweenTries = 200;  // ms

}  // namespace

Message lossMessage(bool replaced) {
    if (replaced)
        return {QT_TRANSLATE_NOOP("core",
                                  "OpenGL lost its context (the graphics driver was reset). The scene is being uploaded again; "
                                  "nothing is lost."),
                {}};
    return {QT_TRANSLATE_NOOP("core",
                              "OpenGL lost its context, and no new one can be made. What is shown stays: save the session and "
                              "start Cullscope again."),
            {}};
}

GpuThread::GpuThread(Options options) : m_options(std::move(options)) {
    m_surface.setFormat(QSurfaceFormat::defaultFormat());
    m_surface.create();
    std::unique_ptr<QOpenGLContext> context = newContext();
    if (!context || !m_surface.isValid())
        throwOpenGl(
            QT_TRANSLATE_NOOP("core", "No OpenGL context can be made on this display. Install a graphics driver or Mesa."));
    context->moveToThread(&m_thread);
    m_worker.moveToThread(&m_thread);
    m_mailbox->thread = this;
    m_thread.setObjectName(QStringLiteral("cullscope-gpu"));
    m_thread.start();
    if (!m_thread.isRunning())
        throwOpenGl(
            QT_TRANSLATE_NOOP("core",
                              "The system gives no thread for OpenGL. Close other programs, or allow this one more memory "
                              "and threads (ulimit)."));
    std::exception_ptr failure;
    QMetaObject::invokeMethod(
        &m_worker,
        [&] {
            try {
                beginIn(std::move(context));
                m_info = requireOpenGl45();
            } catch (...) {
                failure = std::current_exception();
                context.reset();
            }
        },
        Qt::BlockingQueuedConnection);
    if (!failure) return;
    m_thread.quit();
    m_thread.wait();
    std::rethrow_exception(failure);
}

GpuThread::~GpuThread() {
    {
        const std::lock_guard lock(m_mailbox->mutex);
        m_mailbox->thread = nullptr;
    }
    QMetaObject::invokeMethod(
        &m_worker,
        [this] {
            m_renderer.reset();
            if (m_context) m_context->doneCurrent();
            m_context.reset();
            m_lostContexts.clear();
            m_worker.moveToThread(QCoreApplication::instance()->thread());
        },
        Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

std::unique_ptr<QOpenGLContext> GpuThread::newContext() const {
    if (m_options.context) return m_options.context();
    for (const bool notified : {true, false}) {
        QSurfaceFormat format = QSurfaceFormat::defaultFormat();
        format.setOption(QSurfaceFormat::ResetNotification, notified);
        auto context = std::make_unique<QOpenGLContext>();
        context->setFormat(format);
        if (context->create()) return context;
    }
    return nullptr;
}

void GpuThread::beginIn(std::unique_ptr<QOpenGLContext> context) {
    if (!context || !context->makeCurrent(&m_surface))
        throwOpenGl(QT_TRANSLATE_NOOP("core", "The OpenGL context cannot be used on this display. Update the graphics driver."));
    const GlInfo info = requireOpenGl45();
    m_context = std::move(context);
    ++m_number;
    m_buffers = 0;
    m_lost = false;
    QMetaObject::invokeMethod(
        this, [this, info] { m_info = info; }, Qt::QueuedConnection);
}

// ---- Work

void GpuThread::post(std::function<void()> work, Urgency urgency) {
    {
        const std::lock_guard lock(m_queueMutex);
        (urgency == Urgency::Picture ? m_pictures : m_work).push_back(std::move(work));
    }
    // Each post queues one call of runNext(), which takes the most urgent piece of work at the time it runs.
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
    perform(work);
}

void GpuThread::run(const std::function<void()>& work) {
    QMetaObject::invokeMethod(
        &m_worker, [&] { perform(work); }, Qt::BlockingQueuedConnection);
}

void GpuThread::perform(const std::function<void()>& work) {
    work();
    if (losing()) replaceContext();
}

Renderer& GpuThread::renderer() {
    if (!m_renderer) m_renderer = std::make_unique<Renderer>();
    return *m_renderer;
}

// ---- Loss

bool GpuThread::lost() {
    // QOpenGLContext::makeCurrent fails after the driver has reported a reset.
    m_lost = m_lost || !m_context || !m_context->makeCurrent(&m_surface) || cullscope::contextLost() ||
             (m_options.lost && m_options.lost());
    return m_lost;
}

bool GpuThread::losesTooOften() {
    if (!m_sinceLoss.isValid() || m_sinceLoss.elapsed() > kCalm) m_lossesInARow = 0;
    m_sinceLoss.start();
    return ++m_lossesInARow > kMostLossesInARow;
}

void GpuThread::replaceContext() {
    // If the lost context cannot be made current, none is: OpenGL calls then do nothing, and its objects are gone anyway.
    if (!m_context->makeCurrent(&m_surface)) m_context->doneCurrent();
    emit contextGoing();
    m_renderer.reset();
    m_context->doneCurrent();
    if (m_buffers > 0)
        m_lostContexts[m_number] = {std::move(m_context), m_buffers};
    else
        m_context.reset();
    if (!losesTooOften()) replaceWithin(kTries);
    emit contextLost(m_context != nullptr);
}

void GpuThread::replaceWithin(int tries) {
    for (int attempt = 0; attempt < tries && !m_context; ++attempt) {
        // A driver may take some time to restart after a reset.
        if (attempt > 0) QThread::msleep(kPauseBetweenTries);
        try {
            beginIn(newContext());
        } catch (const Error&) {
            // Try again; contextLost reports the failure of the last attempt.
        }
    }
}

bool GpuThread::holds(const SceneBuffersPointer& buffers) {
    const Freer* freer = std::get_deleter<Freer>(buffers);
    return freer && freer->context == m_number && !lost();
}

void GpuThread::requireHeld(const SceneBuffersPointer& buffers) {
    if (!holds(buffers))
        throwOpenGl(QT_TRANSLATE_NOOP("core", "OpenGL lost its context while this picture was drawn. Take the picture again."));
}

// ---- Scenes

SceneBuffersPointer GpuThread::upload(const ScenePointer& scene, Upload upload) {
    if (!m_context) throw Error(ErrorKind::OpenGl, lossMessage(false));
    return ownedByThread(std::make_unique<SceneBuffers>(scene, upload));
}

SceneBuffersPointer GpuThread::share(const ScenePointer& scene, const SceneBuffers& uploaded) {
    return ownedByThread(std::make_unique<SceneBuffers>(scene, uploaded));
}

SceneBuffersPointer GpuThread::ownedByThread(std::unique_ptr<SceneBuffers> buffers) {
    // Finish the transfer here, so that it does not overlap with a timed frame.
    waitForGpu();
    ++m_buffers;
    return {buffers.release(), Freer{m_mailbox, m_number}};
}

void GpuThread::Freer::operator()(const SceneBuffers* buffers) const {
    const std::lock_guard lock(mailbox->mutex);
    // After the thread has ended there is no context to free the buffers in. OpenGL freed its objects with the context; the CPU
    // object remains until the process ends.
    if (GpuThread* thread = mailbox->thread)
        QMetaObject::invokeMethod(
            &thread->m_worker, [thread, buffers, context = context] { thread->free(buffers, context); }, Qt::QueuedConnection);
}

void GpuThread::free(const SceneBuffers* buffers, uint64_t context) {
    const auto old = m_lostContexts.find(context);
    if (old == m_lostContexts.end()) {
        delete buffers;
        --m_buffers;
        return;
    }
    QOpenGLContext& lost = *old->second.context;
    if (!lost.makeCurrent(&m_surface)) lost.doneCurrent();
    delete buffers;
    lost.doneCurrent();
    if (--old->second.buffers == 0) m_lostContexts.erase(old);
    if (m_context) m_lost = !m_context->makeCurrent(&m_surface) || m_lost;
}

}  // namespace cullscope::ui
