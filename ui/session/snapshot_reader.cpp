#include "ui/session/snapshot_reader.h"

#include <QEvent>
#include <QWidget>
#include <algorithm>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kPauseBetweenReadings = 100;  // ms between the beginnings of two readings

/// The first map of directions that the strategy declares; of the same frame's former one if it is of the same object.
CellMapPointer mapOf(const BuiltStrategy& strategy, const FrameLog& log, const std::optional<uint32_t>& picked,
                     const SnapshotReadingPointer& known) {
    for (const Show& show : strategy.info().shows) {
        if (show.kind != Show::Kind::DirectionMap) continue;
        if (known && known->map && picked == known->map->object) return known->map;
        return strategy.directionMap(show.id, log, picked);
    }
    return nullptr;
}

/// The object of the last decision of a log; none: that was about several, or there is none.
std::optional<uint32_t> objectInHand(const FrameLog& log) {
    if (log.decisions.empty() || log.decisions.back().subject.object == Subject::kNoObject) return std::nullopt;
    return log.decisions.back().subject.object;
}

/// The map at a step: of the object in hand. While that is still being decided, what the whole frame decided is shown.
CellMapPointer mapAtStep(const BuiltStrategy& strategy, const FrameLog& whole, const FrameLog& log,
                         const std::optional<uint32_t>& picked, const SnapshotReadingPointer& known) {
    const std::optional<uint32_t> inHand = objectInHand(log);
    CellMapPointer map = mapOf(strategy, log, inHand ? inHand : picked, known);
    return !inHand || (map && map->object == *inHand) ? map : mapOf(strategy, whole, inHand, nullptr);
}

/// Fills `reading` from its view's recorded frame, `whole`, or at a step from the first part of it, `log`; `known` is another
/// reading of that frame, if there is one.
void read(SnapshotReading& reading, const FrameLog& whole, const FrameLog& log, const SnapshotReadingPointer& known) {
    const View view(reading.culling, reading.size);
    const BuiltStrategy& strategy = *reading.strategy;
    const Scene& scene = strategy.scene();
    reading.snapshot = known ? known->snapshot : std::make_shared<const StructureSnapshot>(strategy.snapshot(log));
    reading.listing = strategy.listing(log);
    reading.bars = strategy.bars(log);
    std::optional<uint32_t> picked;
    if (reading.triangle) picked = uint32_t(scene.instanceOf(*reading.triangle));
    reading.map = reading.upTo ? mapAtStep(strategy, whole, log, picked, known) : mapOf(strategy, log, picked, known);
    if (!picked) return;
    reading.why = why(strategy, log, *reading.triangle);
    if (reading.upTo) reading.stepState = triangleStates(scene, log, std::nullopt).states[*reading.triangle];
    reading.pickedListing = strategy.listing(log, *reading.triangle);
    reading.planes = planeDistances(scene, view, *picked);
}

}  // namespace

SnapshotReadingPointer SnapshotReader::readingOf(const Request& request, const ViewFramePointer& frame, const Message& failure,
                                                 const SnapshotReadingPointer& known) {
    auto reading = std::make_shared<SnapshotReading>();
    reading->strategy = request.frame.strategy;
    reading->culling = request.frame.culling;
    reading->size = request.frame.size;
    reading->triangle = request.triangle;
    reading->upTo = request.upTo;
    reading->failure = failure;
    reading->snapshot = std::make_shared<const StructureSnapshot>();
    reading->frame = frameUpTo(frame, request.upTo);
    if (frame) read(*reading, frame->log, reading->frame->log, known);
    return reading;
}

SnapshotReader::SnapshotReader(Session& session, QObject* parent, std::optional<int> view)
    : QObject(parent), m_session(session), m_view(view) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPauseBetweenReadings);
    connect(&m_pause, &QTimer::timeout, this, &SnapshotReader::check);
    for (const auto signal :
         {&Session::sceneChanged, &Session::hiddenChanged, &Session::buffersChanged, &Session::cameraChanged,
          &Session::viewCountChanged, &Session::activeViewChanged, &Session::pickChanged, &Session::stepChanged})
        connect(&session, signal, this, &SnapshotReader::check);
    // No signal reports a view's new size; its next picture or metrics do.
    for (const auto signal :
         {&Session::setupChanged, &Session::strategyBuilt, &Session::pictureChanged, &Session::metricsChanged})
        connect(&session, signal, this, &SnapshotReader::check);
}

void SnapshotReader::readFor(QWidget* widget) {
    m_readers.push_back(widget);
    widget->installEventFilter(this);
    connect(widget, &QObject::destroyed, this, [this, widget] { std::erase(m_readers, widget); });
    check();
}

bool SnapshotReader::eventFilter(QObject* watched, QEvent* event) {
    // Queued: the widget becomes visible only after its show event.
    if (event->type() == QEvent::Show) QMetaObject::invokeMethod(this, &SnapshotReader::check, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

bool SnapshotReader::wanted() const {
    return std::any_of(m_readers.begin(), m_readers.end(), [](const QWidget* widget) { return widget->isVisible(); });
}

std::optional<uint64_t> SnapshotReader::pickedTriangle() const {
    const std::optional<Pick>& pick = m_session.pick();
    if (!pick) return std::nullopt;
    const std::optional<uint32_t> instance = m_session.instanceOf(pick->object);
    if (!instance) return std::nullopt;
    return m_session.scene()->firstTriangle(*instance) + pick->triangle - m_session.opened()->scene->firstTriangle(pick->object);
}

std::optional<SnapshotReader::Request> SnapshotReader::present() const {
    const std::optional<ViewRequest> picture = m_session.viewRequest(view());
    if (!picture || picture->strategy->scenePointer() != m_session.scene()) return std::nullopt;
    return Request{picture->frame(), pickedTriangle(), picture->upTo};
}

bool SnapshotReader::answers(const Request& request) const {
    return m_reading && m_reading->strategy == request.frame.strategy && m_reading->culling == request.frame.culling &&
           m_reading->size == request.frame.size && m_reading->triangle == request.triangle && m_reading->upTo == request.upTo;
}

bool SnapshotReader::fresh() const {
    const std::optional<Request> request = present();
    return request && answers(*request);
}

void SnapshotReader::check() {
    // Another scene numbers its objects differently, and a refused strategy decides nothing.
    const bool refused = m_session.slot(m_session.culledBy(view())).refused();
    const bool outdated = m_reading && (refused || m_reading->strategy->scenePointer() != m_session.scene());
    if (outdated) m_reading = nullptr;
    // A step is read for the panels once its picture is painted; stepChanged follows.
    if (m_session.stepAwaitsPicture() && !outdated) return;
    const bool fresh = this->fresh();
    if (fresh != std::exchange(m_wasFresh, fresh) || outdated) emit changed();
    // A step is short, and what panels show of it is asked for at once.
    const bool pauses = m_pause.isActive() && !m_session.stepOf(view());
    if (!fresh && wanted() && !busy() && !pauses) start();
}

void SnapshotReader::start() {
    const std::optional<Request> request = present();
    if (!request) return;
    const bool same = m_reading && m_reading->failure.empty() && m_reading->strategy == request->frame.strategy &&
                      m_reading->culling == request->frame.culling && m_reading->size == request->frame.size &&
                      m_reading->upTo == request->upTo;
    const SnapshotReadingPointer known = same ? m_reading : nullptr;
    m_pause.start();
    ++m_begun;
    GpuThread& gpu = *m_session.gpu();
    // The frame is there where the view's picture is; it is read beside the window and the GPU thread.
    const auto fetch = [this, &gpu, request = *request, known, frames = m_session.frames()](GpuJobs::Step& step) {
        // What a lost context answers is worth nothing; it is asked again with the buffers of the new one.
        if (gpu.lost()) return;
        ViewFramePointer frame;
        Message failure;
        try {
            frame = frames->of(request.frame, gpu.renderer());
        } catch (const Error& error) {
            failure = error.message();
        }
        if (!gpu.lost()) step.deliver([this, request, known, frame, failure] { startReading(request, frame, failure, known); });
    };
    m_gpuJobs.start(gpu, fetch, {.buffers = {request->frame.buffers}, .urgency = Urgency::Picture});
}

void SnapshotReader::startReading(const Request& request, const ViewFramePointer& frame, const Message& failure,
                                  const SnapshotReadingPointer& known) {
    const auto work = [this, request, frame, failure, known](const std::stop_token& stop) {
        SnapshotReadingPointer reading = readingOf(request, frame, failure, known);
        if (stop.stop_requested()) return Background::Delivery();
        return Background::Delivery(
            [this, request, reading = std::move(reading)]() mutable { take(request, std::move(reading)); });
    };
    m_background.start(work, [this, request](const std::exception& error) {
        const Message why = sentenceOf(error, QT_TRANSLATE_NOOP("core", "What the strategy decided cannot be read: %1"));
        return Background::Delivery([this, request, why] { take(request, readingOf(request, nullptr, why, nullptr)); });
    });
}

void SnapshotReader::take(const Request& request, SnapshotReadingPointer reading) {
    const std::optional<Request> now = present();
    if (now && now->frame.sameFrame(request.frame) && now->triangle == request.triangle && now->upTo == request.upTo) {
        m_reading = std::move(reading);
        m_wasFresh = true;
        emit changed();
    }
    check();
}

std::optional<TriangleState> SnapshotReader::pickedState() const {
    const std::optional<uint64_t> triangle = pickedTriangle();
    // The truth is compared with the whole frame, which a step is not.
    if (m_session.stepOf(view()) != nullptr)
        return triangle && m_reading && m_reading->triangle == triangle ? m_reading->stepState : std::nullopt;
    const ViewMetrics& figures = m_session.figures(view());
    if (!triangle || figures.state != ViewMetrics::State::Ready || !figures.states) return std::nullopt;
    if (!figures.subject.buffers || figures.subject.buffers->scenePointer() != m_session.scene()) return std::nullopt;
    return figures.states->states[*triangle];
}

}  // namespace cullscope::ui
