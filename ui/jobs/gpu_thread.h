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

/// What contextLost tells the user.
[[nodiscard]] Message lossMessage(bool replaced);

/// What goes first on the GPU thread.
enum class Urgency {
    Picture,  ///< somebody is waiting for it: goes before everything that has not begun
    Work      ///< uploads and measurements, in the order of posting
};

/// A thread with an OpenGL context of its own: draws, uploads scenes and measures, so that none of them stops the window. The
/// context shares nothing with the window's, so that neither falls with the other. Where a driver's reset takes it, a new one
/// takes its place: what was made in the old one is let go, and contextLost says that it is to be made again. Made, asked and
/// destroyed on the window's thread.
class GpuThread : public QObject {
    Q_OBJECT

public:
    /// For tests: no driver resets on demand.
    struct Options {
        std::function<bool()> lost;  ///< asked on the thread with the context current; empty: OpenGL's own word alone
        std::function<std::unique_ptr<QOpenGLContext>()> context;  ///< null: none can be made; empty: one with reset notification
    };

    /// Throws Error(OpenGl) where there is no OpenGL 4.5.
    explicit GpuThread(Options options = Options());
    /// Finishes what was posted.
    ~GpuThread() override;

    /// Runs `work` on the thread with the context current.
    void post(std::function<void()> work, Urgency urgency = Urgency::Work);
    /// Runs `work` there and waits for it and for everything that was posted before.
    void run(const std::function<void()>& work);

    /// Uploads a scene (on the thread: call from posted work only). The buffers are freed on the thread, whoever lets go of them;
    /// those that outlive this object went with its context. Throws what SceneBuffers throws, and Error(OpenGl) where the context
    /// was lost and no new one can be made.
    [[nodiscard]] SceneBuffersPointer upload(const ScenePointer& scene, Upload upload = Upload::Vbo);
    /// The same for a scene of the very meshes that `uploaded` holds: nothing is uploaded again.
    [[nodiscard]] SceneBuffersPointer share(const ScenePointer& scene, const SceneBuffers& uploaded);

    /// One for whoever asks OpenGL and draws nothing (on the thread, with the context not lost); goes with the context.
    [[nodiscard]] Renderer& renderer();

    /// Whether the context is gone (on the thread): what was done in it since the work in hand began is worth nothing.
    [[nodiscard]] bool lost();
    /// Whether it was lost in the work in hand (on the thread), so that contextLost is still to come.
    [[nodiscard]] bool losing() { return m_context && lost(); }
    /// Whether the buffers are of the present context, and that is not lost (on the thread): others must not be drawn.
    [[nodiscard]] bool holds(const SceneBuffersPointer& buffers);
    /// Throws Error(OpenGl) where it does not hold them (on the thread).
    void requireHeld(const SceneBuffersPointer& buffers);

    [[nodiscard]] const GlInfo& info() const { return m_info; }

signals:
    /// On the thread (connect directly), with the lost context current as far as it can be: let go of what was made in it.
    void contextGoing();
    /// On the window's thread. False: no new context can be made; what is shown stays, and nothing new is drawn.
    void contextLost(bool replaced);

private:
    /// Outlives the thread, for what is freed late.
    struct Mailbox {
        std::mutex mutex;
        GpuThread* thread = nullptr;  ///< null: the thread is gone
    };
    /// Frees buffers on the thread, in the context that they were made in.
    struct Freer {
        std::shared_ptr<Mailbox> mailbox;
        uint64_t context = 0;

        void operator()(const SceneBuffers* buffers) const;
    };
    /// Kept until its last buffers are freed: a number of the old context names something else in the new one.
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
    GlInfo m_info;  ///< on the window's thread

    // On the thread:
    std::unique_ptr<QOpenGLContext> m_context;  ///< null: lost, and no new one can be made
    std::unique_ptr<Renderer> m_renderer;       ///< of the context; null: not asked for yet
    uint64_t m_number = 0;                      ///< of the context
    size_t m_buffers = 0;                       ///< living in it
    bool m_lost = false;
    std::map<uint64_t, LostContext> m_lostContexts;
    QElapsedTimer m_sinceLoss;
    int m_lossesInARow = 0;
};

}  // namespace cullscope::ui
