#include "ui/jobs/picture_maker.h"

#include <QCoreApplication>
#include <new>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

// While the user moves a view, it has two turns of three, so that its picture follows within 100 ms beside seven other views.
constexpr int kTurnsOfFirst = 2;

/// Runs `draw` and stores the message of what it throws in `failure`.
template <typename Draw>
ViewPicturePointer guarded(Message& failure, const Draw& draw) {
    try {
        return draw();
    } catch (const Error& error) {
        failure = error.message();
    } catch (const std::bad_alloc&) {
        failure = {
            QT_TRANSLATE_NOOP("core", "There is not enough memory to draw this view. Make the picture or the scene smaller."),
            {}};
    } catch (const std::exception& error) {
        failure = {QT_TRANSLATE_NOOP("core", "This view cannot be drawn: %1"), {error.what()}};
    }
    return nullptr;
}

}  // namespace

PictureMaker::PictureMaker(GpuThread& gpu, int views, Wish wish, QObject* parent)
    : QObject(parent),
      m_gpu(gpu),
      m_wish(std::move(wish)),
      m_drawer(std::make_shared<ViewPictureDrawer>()),
      m_views(size_t(views)) {
    connect(
        &gpu, &GpuThread::contextGoing, this, [drawer = m_drawer] { *drawer = ViewPictureDrawer(); }, Qt::DirectConnection);
}

PictureMaker::~PictureMaker() {
    m_jobs.invalidate();
    // Destroy OpenGL objects on the GPU thread.
    m_gpu.run([this] { *m_drawer = ViewPictureDrawer(); });
}

void PictureMaker::forget() {
    m_jobs.invalidate();
    m_drawing = false;
    for (ViewState& state : m_views) {
        state.picture = nullptr;
        state.given.reset();
    }
}

bool PictureMaker::wants(int view) const {
    const std::optional<ViewRequest> wish = m_wish(view);
    return wish && wish->complete() && wish != m_views[size_t(view)].given;
}

bool PictureMaker::isCurrent(int view) const {
    const ViewPicturePointer& made = picture(view);
    return made && m_wish(view) == made->request;
}

bool PictureMaker::busy() const {
    if (m_drawing) return true;
    for (int view = 0; view < int(m_views.size()); ++view)
        if (wants(view)) return true;
    return false;
}

void PictureMaker::update(int first) {
    m_first = first;
    schedule();
}

void PictureMaker::schedule() {
    if (m_drawing || std::exchange(m_scheduled, true)) return;
    // Queued, so that several changes during one event lead to one picture.
    QMetaObject::invokeMethod(
        this,
        [this] {
            m_scheduled = false;
            drawNext();
        },
        Qt::QueuedConnection);
}

int PictureMaker::nextView() const {
    const int count = int(m_views.size());
    if (m_turnsOfFirst < kTurnsOfFirst && wants(m_first)) return m_first;
    for (int step = 0; step < count; ++step) {
        const int view = (m_cursor + step) % count;
        if (view != m_first && wants(view)) return view;
    }
    return wants(m_first) ? m_first : -1;
}

void PictureMaker::drawNext() {
    if (m_drawing) return;
    const int view = nextView();
    if (view < 0) return;
    m_turnsOfFirst = view == m_first ? m_turnsOfFirst + 1 : 0;
    if (view != m_first) m_cursor = view + 1;
    m_drawing = true;
    const uint64_t job = m_jobs.begin();
    m_gpu.post(
        [this, job, view, request = *m_wish(view), drawer = m_drawer] {
            if (!m_jobs.isCurrent(job)) return;
            Message failure;
            ViewPicturePointer picture;
            if (m_gpu.holds(request.buffers)) picture = guarded(failure, [&] { return drawer->draw(request); });
            const bool held = m_gpu.holds(request.buffers);
            QMetaObject::invokeMethod(
                this,
                [this, job, view, request, picture, failure, held] {
                    if (!m_jobs.isCurrent(job)) return;
                    if (held)
                        finish(view, request, picture, failure);
                    else
                        passOver(view, request);
                },
                Qt::QueuedConnection);
        },
        Urgency::Picture);
}

void PictureMaker::finish(int view, const ViewRequest& request, const ViewPicturePointer& picture, const Message& failure) {
    m_drawing = false;
    ViewState& state = m_views[size_t(view)];
    state.given = request;
    state.picture = picture;
    if (picture) {
        ++state.drawn;
        emit pictureMade(view);
    } else {
        emit failed(view, failure);
    }
    schedule();
}

void PictureMaker::passOver(int view, const ViewRequest& request) {
    m_drawing = false;
    // The picture before stays; the new buffers after the upload to the new context make a new request.
    m_views[size_t(view)].given = request;
    schedule();
}

void PictureMaker::pick(const ViewRequest& request, int x, int y,
                        std::function<void(const std::optional<ViewPictureDrawer::Picked>&)> found) {
    m_gpu.post(
        [this, request, x, y, found = std::move(found), drawer = m_drawer] {
            if (!m_gpu.holds(request.buffers)) return;
            std::optional<ViewPictureDrawer::Picked> picked;
            Message failure;  // not reported: drawing the view fails in the same way and reports it
            (void)guarded(failure, [&]() -> ViewPicturePointer {
                picked = drawer->pick(request, x, y);
                return nullptr;
            });
            if (!m_gpu.holds(request.buffers)) return;
            QMetaObject::invokeMethod(
                this, [found, picked] { found(picked); }, Qt::QueuedConnection);
        },
        Urgency::Picture);
}

ViewPicturePointer PictureMaker::drawNow(const ViewRequest& request) {
    ViewPicturePointer picture;
    std::exception_ptr failure;
    m_gpu.run([&] {
        try {
            m_gpu.requireHeld(request.buffers);
            picture = m_drawer->draw(request);
            m_gpu.requireHeld(request.buffers);
        } catch (...) {
            failure = std::current_exception();
        }
    });
    if (failure) std::rethrow_exception(failure);
    return picture;
}

}  // namespace cullscope::ui
