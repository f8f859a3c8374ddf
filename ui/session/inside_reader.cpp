#include "ui/session/inside_reader.h"

#include <QEvent>
#include <QWidget>
#include <algorithm>

namespace cullscope::ui {

namespace {

constexpr int kPause = 100;  // ms between two culls' beginnings

}  // namespace

size_t placeOfMap(const Inside& inside, const std::optional<uint32_t>& instance) {
    const std::vector<InsideMap>& maps = inside.maps;
    const auto place = [&](const auto& matches) {
        return size_t(std::find_if(maps.begin(), maps.end(), matches) - maps.begin());
    };
    size_t found = maps.size();
    if (instance) found = place([&](const InsideMap& map) { return map.decision.instance == *instance; });
    if (found == maps.size())
        found = place([](const InsideMap& map) { return map.decision.relation != SphereRelation::Outside; });
    return found == maps.size() ? 0 : found;
}

InsideReader::InsideReader(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &InsideReader::check);
    for (const auto signal : {&Session::sceneChanged, &Session::hiddenChanged, &Session::buffersChanged, &Session::cameraChanged,
                              &Session::viewCountChanged, &Session::activeViewChanged, &Session::pickChanged})
        connect(&session, signal, this, &InsideReader::check);
    // A changed size of a view shows by its next picture, or by its figures.
    for (const auto signal :
         {&Session::setupChanged, &Session::strategyBuilt, &Session::pictureChanged, &Session::figuresChanged})
        connect(&session, signal, this, &InsideReader::check);
}

InsideReader::~InsideReader() { m_background.cancel(); }

void InsideReader::readFor(QWidget* widget) {
    m_readers.push_back(widget);
    widget->installEventFilter(this);
    connect(widget, &QObject::destroyed, this, [this, widget] { std::erase(m_readers, widget); });
    check();
}

bool InsideReader::eventFilter(QObject* watched, QEvent* event) {
    // The widget is not visible yet when it hears that it will be.
    if (event->type() == QEvent::Show) QMetaObject::invokeMethod(this, &InsideReader::check, Qt::QueuedConnection);
    return QObject::eventFilter(watched, event);
}

bool InsideReader::wanted() const {
    return std::any_of(m_readers.begin(), m_readers.end(), [](const QWidget* widget) { return widget->isVisible(); });
}

std::optional<uint64_t> InsideReader::pickedTriangle() const {
    const std::optional<Pick>& pick = m_session.pick();
    if (!pick) return std::nullopt;
    const std::optional<uint32_t> instance = m_session.instanceOf(pick->object);
    if (!instance) return std::nullopt;
    return m_session.scene()->firstTriangle(*instance) + pick->triangle - m_session.opened()->scene->firstTriangle(pick->object);
}

std::optional<InsideReader::Request> InsideReader::present() const {
    const std::optional<ViewRequest> view = m_session.viewRequest(m_session.activeView());
    if (!view || view->strategy->scene != m_session.scene()) return std::nullopt;
    return Request{view->strategy, view->culling, view->cullingSize, pickedTriangle()};
}

bool InsideReader::answers(const Request& request) const {
    return m_reading && request == Request{m_reading->strategy, m_reading->culling, m_reading->size, m_reading->triangle};
}

bool InsideReader::fresh() const {
    const std::optional<Request> request = present();
    return request && answers(*request);
}

void InsideReader::check() {
    // Another scene numbers its objects in another way.
    const bool outdated = m_reading && m_reading->strategy->scene != m_session.scene();
    if (outdated) m_reading = nullptr;
    const bool fresh = this->fresh();
    if (fresh != std::exchange(m_wasFresh, fresh) || outdated) emit changed();
    if (!fresh && wanted() && !m_background.busy() && !m_pause.isActive()) start();
}

void InsideReader::start() {
    const std::optional<Request> request = present();
    if (!request) return;
    const bool same = m_reading && m_reading->strategy == request->strategy && m_reading->culling == request->culling &&
                      m_reading->size == request->size;
    m_pause.start();
    ++m_begun;
    m_background.start([this, request = *request, known = same ? m_reading->inside : nullptr](const std::stop_token& stop) {
        auto reading = std::make_shared<InsideReading>();
        reading->strategy = request.strategy;
        reading->culling = request.culling;
        reading->size = request.size;
        reading->triangle = request.triangle;
        const View view(request.culling, request.size);
        const Strategy& strategy = *request.strategy->strategy;
        Trace trace;
        Verdict verdict;
        {
            const std::lock_guard lock(request.strategy->mutex);
            verdict = request.strategy->strategy->cull(view, &trace);
        }
        if (stop.stop_requested()) return Background::Delivery();
        reading->inside = known ? known : std::make_shared<const Inside>(strategy.inside(trace));
        if (!reading->inside->maps.empty()) {
            std::optional<uint32_t> picked;
            if (request.triangle) picked = uint32_t(request.strategy->scene->instanceOf(*request.triangle));
            reading->map = placeOfMap(*reading->inside, picked);
            (void)*reading->inside->maps[reading->map].maps;
        }
        if (request.triangle)
            reading->why = why(*request.strategy->scene, view, strategy, verdict.drawList, trace, *request.triangle);
        return Background::Delivery(
            [this, request, reading = std::move(reading)]() mutable { take(request, std::move(reading)); });
    });
}

void InsideReader::take(const Request& request, InsideReadingPointer reading) {
    if (present() == request) {
        m_reading = std::move(reading);
        m_wasFresh = true;
        emit changed();
    }
    check();
}

std::optional<TriangleState> InsideReader::pickedState() const {
    const std::optional<uint64_t> triangle = pickedTriangle();
    const Figures& figures = m_session.figures(m_session.activeView());
    if (!triangle || figures.state != Figures::State::Ready || !figures.states) return std::nullopt;
    if (!figures.subject.buffers || figures.subject.buffers->scenePointer() != m_session.scene()) return std::nullopt;
    return figures.states->states[*triangle];
}

}  // namespace cullscope::ui
