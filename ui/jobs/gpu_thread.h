#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>

#include "core/base/message.h"
#include "core/gpu/context.h"
#include "core/gpu/renderer.h"
#include "core/gpu/scene_buffers.h"

namespace cullscope::ui {

using SceneBuffersPointer = std::shared_ptr<const SceneBuffers>;

/// The text that accompanies contextLost, for the user.
[[nodiscard]] Message lossMessage(bool replaced);

/// The queue of the GPU thread that a piece of work goes to.
enum class Urgency {
    Picture,  ///< a view waits for the picture: runs before all work that has not begun
    Work      ///< uploads and measurements, in the order in which they were posted
};

/// A thread with an OpenGL context of its own. It draws, uploads scenes and measures, so that the window never blocks. The
/// context shares nothing with the window's context, so that a loss of one does not destroy the other. After a driver reset a new
/// context replaces the lost one: objects of the old context are released, and contextLost tells their owners to create them
/// again. Construct and destroy it on the window's thread; call its functions there too, unless their comments say otherwise.
class GpuThread : public QObject {
    Q_OBJECT

public:
    /// Stand-ins for tests, because no driver resets on demand.
    struct Options {
        /// Additional test for a lost context, called on the thread with the context current; empty: only OpenGL is queried.
        std::function<bool()> lost;
        /// Makes a context or returns null; empty: GpuThread makes one, with reset notification if the driver offers it.
        std::function<std::unique_ptr<QOpenGLContext>()> context;
    };

    /// Throws Error(OpenGl) if OpenGL 4.5 is not available.
    explicit GpuThread(Options options = Options());
    /// Finishes all posted work.
    ~GpuThread() override;

    /// Runs `work` on the thread with the context current. Returns at once; may be called on any thread.
    void post(std::function<void()> work, Urgency urgency = Urgency::Work);
    /// Runs `work` on the thread after all work posted before, and waits for it.
    void run(const std::function<void()>& work);

    /// Uploads a scene. Call it from posted work only. The thread frees the buffers, on whichever thread their last owner
    /// releases them; OpenGL has already freed the buffers that outlive this object, with its context. Throws what SceneBuffers
    /// throws, and Error(OpenGl) if the context was lost and no new one can be made.
    [[nodiscard]] SceneBuffersPointer upload(const ScenePointer& scene, Upload upload = Upload::Vbo);
    /// Does the same for a scene whose meshes `uploaded` holds already: shares its buffers and uploads nothing.
    [[nodiscard]] SceneBuffersPointer share(const ScenePointer& scene, const SceneBuffers& uploaded);

    /// A renderer for culls that query OpenGL and draw no picture. Call it on the thread, with the context not lost; the renderer
    /// is destroyed with the context.
    [[nodiscard]] Renderer& renderer();

    /// Whether the context is lost. Call it on the thread. If it is, all results since the current work began are invalid.
    [[nodiscard]] bool lost();
    /// Whether the context was lost during the current work, so that contextLost is still to be emitted. Call it on the thread.
    [[nodiscard]] bool losing() { return m_context && lost(); }
    /// Whether the buffers belong to the present context, and that one is not lost. Other buffers must not be drawn. Call it on
    /// the thread.
    [[nodiscard]] bool holds(const SceneBuffersPointer& buffers);
    /// Throws Error(OpenGl) if holds() is false. Call it on the thread.
    void requireHeld(const SceneBuffersPointer& buffers);

    [[nodiscard]] const GlInfo& info() const { return m_info; }

signals:
    /// Emitted on the thread; connect directly. Receivers release what they made in the lost context, which is still current if
    /// the driver allows it.
    void contextGoing();
    /// Emitted on the window's thread. False: no new context can be made; the shown pictures stay, and no new ones are drawn.
    void contextLost(bool replaced);

private:
    /// Outlives the thread, for buffers that are released after it ended.
    struct Mailbox {
        std::mutex mutex;
        GpuThread* thread = nullptr;  ///< null: the thread has ended
    };
    /// Deleter that frees buffers on the thread, in the context in which they were made.
    struct Freer {
        std::shared_ptr<Mailbox> mailbox;
        uint64_t context = 0;

        void operator()(const SceneBuffers* buffers) const;
    };
    /// A lost context, kept until its last buffers are freed: an object name of the old context may name another object in the
    /// new one.
    struct LostContext {
        std::unique_ptr<QOpenGLContext> context;
        size_t buffers = 0;
    };

    using Queue = std::deque<std::function<void()>>;

    [[nodiscard]] std::unique_ptr<QOpenGLContext> newContext() const;
    void beginIn(std::unique_ptr<QOpenGLContext> context);
    void runNext();
    void perform(const std::function<void()>& work);
    void replaceContext();
    void replaceWithin(int tries);
    [[nodiscard]] bool losesTooOften();
    [[nodiscard]] SceneBuffersPointer ownedByThread(std::unique_ptr<SceneBuffers> buffers);
    void free(const SceneBuffers* buffers, uint64_t context);

    Options m_options;
    QOffscreenSurface m_surface;
    std::mutex m_queueMutex;
    Queue m_pictures, m_work;
    QThread m_thread;
    QObject m_worker;
    std::shared_ptr<Mailbox> m_mailbox = std::make_shared<Mailbox>();
    GlInfo m_info;  ///< read and written on the window's thread

    // Used on the thread only:
    std::unique_ptr<QOpenGLContext> m_context;  ///< null: the context was lost and no new one can be made
    std::unique_ptr<Renderer> m_renderer;       ///< made in m_context; null: renderer() was not called yet
    uint64_t m_number = 0;                      ///< counts the contexts; identifies m_context
    size_t m_buffers = 0;                       ///< number of buffers that exist in m_context
    bool m_lost = false;
    std::map<uint64_t, LostContext> m_lostContexts;
    QElapsedTimer m_sinceLoss;
    int m_lossesInARow = 0;
};

}  // namespace cullscope::ui
