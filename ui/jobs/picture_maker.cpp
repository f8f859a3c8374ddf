#include "ui/jobs/picture_maker.h"

#include <QCoreApplication>

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
    } catch (const std::exception& error) {
        // A frame that was ended because it is not wanted has no picture, and there is nothing to tell.
        const auto* known = dynamic_cast<const Error*>(&error);
        if (known != nullptr && known->kind() == ErrorKind::Interrupted) return nullptr;
        failure = sentenceOf(
            error, QT_TRANSLATE_NOOP("core", "This view cannot be drawn: %1"),
            QT_TRANSLATE_NOOP("core", "There is not enough memory to draw this view. Make the picture or the scene smaller."));
    }
    return nullptr;
}

}  // namespace

PictureMaker::PictureMaker(GpuThread& gpu, int views, ViewFramesPointer frames, Wish wish, QObject* parent)
    : QObject(parent),
      m_gpu(gpu),
      m_wish(std::move(wish)),
      m_drawer(std::make_shared<ViewPictureDrawer>(gpu, std::move(frames))),
      m_views(size_t(views)) {
    connect(
        &gpu, &GpuThread::contextGoing, this, [drawer = m_drawer] { drawer->letGo(); }, Qt::DirectConnection);
}

PictureMaker::~PictureMaker() {
    m_stopOfDrawing.request_stop();
    m_jobs.cancel();
    m_picks.cancel();
    // What lives on the GPU thread ends there.
    m_gpu.run([this] { m_drawer->letGo(); });
}

void PictureMaker::forget() {
    m_stopOfDrawing.request_stop();
    m_jobs.cancel();
    for (ViewState& state : m_views) {
        state.picture = nullptr;
        state.given.reset();
    }
    m_gpu.post([frames = m_drawer->frames()] { frames->forget(); });
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
    if (m_jobs.busy()) return true;
    for (int view = 0; view < int(m_views.size()); ++view)
        if (wants(view)) return true;
    return false;
}

void PictureMaker::update(int first) {
    m_first = first;
    endOvertaken();
    schedule();
}

void PictureMaker::endOvertaken() {
    if (!m_jobs.busy() || m_drawsCoarsely) return;
    const std::optional<ViewRequest> wish = m_wish(m_drawnView);
    if (wish && wish->coarse) m_stopOfDrawing.request_stop();
}

void PictureMaker::schedule() {
    if (m_jobs.busy() || std::exchange(m_scheduled, true)) return;
    // Many changes of one event are one wish.
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
    if (m_jobs.busy()) return;
    const int view = nextView();
    if (view < 0) return;
    m_turnsOfFirst = view == m_first ? m_turnsOfFirst + 1 : 0;
    if (view != m_first) m_cursor = view + 1;
    const ViewRequest request = *m_wish(view);
    m_drawnView = view;
    m_drawsCoarsely = request.coarse != nullptr;
    m_stopOfDrawing = std::stop_source();
    const auto draw = [this, view, request, drawer = m_drawer, stop = m_stopOfDrawing.get_token()](GpuJobs::Step& step) {
        Message failure;
        const ViewPicturePointer picture = guarded(failure, [&] { return drawer->draw(request, stop); });
        // A picture that was ended is drawn once it is wished for again.
        if (!picture && stop.stop_requested())
            step.deliver([this] { schedule(); });
        else
            step.deliver([this, view, request, picture, failure] { finish(view, request, picture, failure); });
    };
    const auto lost = [this, view, request] { passOver(view, request); };
    m_jobs.start(m_gpu, draw, {.buffers = {request.buffers}, .lost = lost, .urgency = Urgency::Picture});
}

void PictureMaker::finish(int view, const ViewRequest& request, const ViewPicturePointer& picture, const Message& failure) {
    if (!picture && failure.empty()) return passOver(view, request);
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
    // The picture stays until the scene is in the new context, which makes another wish.
    m_views[size_t(view)].given = request;
    schedule();
}

void PictureMaker::pick(const ViewRequest& request, int x, int y,
                        std::function<void(const std::optional<ViewPictureDrawer::Picked>&)> found) {
    const auto lookUp = [request, x, y, found = std::move(found), drawer = m_drawer](GpuJobs::Step& step) {
        std::optional<ViewPictureDrawer::Picked> picked;
        Message failure;  // the same that drawing the view meets, and tells
        (void)guarded(failure, [&]() -> ViewPicturePointer {
            picked = drawer->pick(request, x, y);
            return nullptr;
        });
        step.deliver([found, picked] { found(picked); });
    };
    m_picks.start(m_gpu, lookUp, {.buffers = {request.buffers}, .urgency = Urgency::Picture});
}

std::optional<ViewPictureDrawer::Picked> PictureMaker::pickNow(const ViewRequest& request, int x, int y) {
    std::optional<ViewPictureDrawer::Picked> picked;
    m_gpu.run([&] {
        Message failure;  // as above
        (void)guarded(failure, [&]() -> ViewPicturePointer {
            m_gpu.requireHeld(request.buffers);
            picked = m_drawer->pick(request, x, y);
            return nullptr;
        });
    });
    return picked;
}

void PictureMaker::pickIn(const ViewRequest& request, const PictureTile& within,
                          std::function<void(const std::vector<uint64_t>&)> found) {
    const auto lookUp = [request, within, found = std::move(found), drawer = m_drawer](GpuJobs::Step& step) {
        std::vector<uint64_t> triangles;
        Message failure;  // as above
        (void)guarded(failure, [&]() -> ViewPicturePointer {
            triangles = drawer->trianglesIn(request, within);
            return nullptr;
        });
        step.deliver([found, triangles = std::move(triangles)] { found(triangles); });
    };
    m_picks.start(m_gpu, lookUp, {.buffers = {request.buffers}, .urgency = Urgency::Picture});
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
