#include "ui/session/stepper.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/error.h"
#include "core/frame/entry_words.h"
#include "ui/text/terms.h"

namespace cullscope::ui {

namespace {

constexpr int kBetweenSteps = 15;  // ms between two looks at the clock

}  // namespace

Stepper::Stepper(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_timer.setInterval(kBetweenSteps);
    connect(&m_timer, &QTimer::timeout, this, &Stepper::advance);
    connect(&session, &Session::sceneChanged, this, &Stepper::stop);
    connect(&session, &Session::stepChanged, this, &Stepper::changed);
    for (const auto signal :
         {&Session::hiddenChanged, &Session::buffersChanged, &Session::cameraChanged, &Session::viewCountChanged})
        connect(&session, signal, this, &Stepper::check);
    // No signal reports a view's new size; its next picture does.
    for (const auto signal : {&Session::setupChanged, &Session::strategyBuilt, &Session::pictureChanged})
        connect(&session, signal, this, &Stepper::check);
}

void Stepper::start() {
    if (!m_session.scene() || !m_session.gpu()) return;
    stop();
    m_view = m_session.culledBy(m_session.activeView());
    check();
    emit changed();
}

void Stepper::startAt(const LogPlace& place) {
    start();
    if (active()) m_begin = place;
}

void Stepper::stop() {
    if (!active()) return;
    m_begin.reset();
    m_timer.stop();
    m_jobs.cancel();
    m_reading.reset();
    m_stepper.reset();
    m_frame = nullptr;
    m_failure = {};
    m_view = -1;
    m_session.setStep(std::nullopt);
    emit changed();
}

std::optional<FrameRequest> Stepper::wanted() const {
    for (const int view : m_session.shownViews())
        if (m_session.culledBy(view) == m_view)
            if (const std::optional<ViewRequest> request = m_session.viewRequest(view)) return request->frame();
    return std::nullopt;
}

void Stepper::check() {
    if (!active() || m_reading) return;
    const std::optional<FrameRequest> request = wanted();
    if (request && !(m_frame && m_frame->request.sameFrame(*request))) read(*request);
}

void Stepper::read(const FrameRequest& request) {
    m_reading = request;
    GpuThread& gpu = *m_session.gpu();
    const auto fetch = [this, &gpu, request, frames = m_session.frames()](GpuJobs::Step& step) {
        if (gpu.lost()) return step.deliver([this] { m_reading.reset(); });
        ViewFramePointer frame;
        Message failure;
        try {
            frame = frames->of(request, gpu.renderer());
        } catch (const Error& error) {
            failure = error.message();
        }
        step.deliver([this, frame, failure] {
            m_reading.reset();
            m_failure = failure;
            if (frame) take(frame);
            emit changed();
            if (frame) check();
        });
    };
    m_jobs.start(gpu, fetch, {.buffers = {request.buffers}, .lost = [this] { m_reading.reset(); }, .urgency = Urgency::Picture});
}

void Stepper::take(const ViewFramePointer& frame) {
    size_t entries = 0;
    if (m_begin)
        entries = entriesAtShare(m_begin->entries, m_begin->whole, frame->log.entries());
    else if (m_stepper)
        entries = entriesAtShare(m_stepper->entries(), m_stepper->log().entries(), frame->log.entries());
    m_frame = frame;
    m_snapshot = frame->request.strategy->snapshot(frame->log);
    m_stepper.emplace(std::shared_ptr<const FrameLog>(frame, &frame->log));
    m_stepper->jump(m_stepper->steps().stepWith(entries));
    m_stepper->setBreakpoints(m_breakpoints);
    m_stepper->setSpeed(m_speed);
    show();
}

void Stepper::show() {
    ShownStep step{m_view, {m_stepper->entries(), m_stepper->log().entries()}, m_stepper->step(), m_stepper->count(), m_frame,
                   {}};
    if (const std::optional<FrameEntry> entry = m_stepper->current())
        step.shape = subjectShape(m_frame->request.strategy->scene(), m_frame->log, m_snapshot, *entry);
    if (step.shape.node) {
        SubjectShape group = m_frame->request.strategy->groupShape(m_snapshot, *step.shape.node);
        step.shape.polygons = std::move(group.polygons);
        if (step.shape.triangles.empty()) step.shape.triangles = std::move(group.triangles);
    }
    const bool same = m_session.step() && *m_session.step() == step;
    m_session.setStep(step);
    if (same) emit changed();
}

void Stepper::forward() {
    m_timer.stop();
    m_begin.reset();
    if (m_stepper && m_stepper->forward()) show();
}

void Stepper::back() {
    m_timer.stop();
    m_begin.reset();
    if (m_stepper && m_stepper->back()) show();
}

void Stepper::jump(size_t step) {
    m_timer.stop();
    m_begin.reset();
    if (!m_stepper || m_stepper->step() == std::min(step, m_stepper->count())) return;
    m_stepper->jump(step);
    show();
}

void Stepper::toEnd() {
    if (m_stepper) jump(m_stepper->count());
}

void Stepper::toBreakpoint(bool onwards) {
    m_timer.stop();
    m_begin.reset();
    if (!m_stepper) return;
    (void)(onwards ? m_stepper->run(m_stepper->count()) : m_stepper->runBack(m_stepper->count()));
    show();
}

void Stepper::play(bool on) {
    m_timer.stop();
    m_begin.reset();
    if (on && m_stepper) {
        if (m_stepper->step() == m_stepper->count()) m_stepper->jump(0);
        show();
        m_clock.start();
        m_timer.start();
    }
    emit changed();
}

void Stepper::advance() {
    // The next step waits for the picture of the present one; the steps that are due by then are made together.
    const std::vector<int> views = m_session.shownViews();
    const bool drawn = std::ranges::none_of(views, [this](int view) {
        return m_session.stepOf(view) != nullptr && m_session.viewRequest(view) && !m_session.pictures()->isCurrent(view);
    });
    const double seconds = double(m_clock.nsecsElapsed()) / 1e9;
    if (!drawn || !m_stepper) return;
    m_clock.start();
    const size_t before = m_stepper->step();
    const bool goesOn = m_stepper->play(seconds);
    if (!goesOn) m_timer.stop();
    if (m_stepper->step() != before || !goesOn) show();
}

void Stepper::setSpeed(double stepsPerSecond) {
    m_speed = std::clamp(stepsPerSecond, 0.1, kMostSpeed);
    if (m_stepper) m_stepper->setSpeed(m_speed);
}

void Stepper::setBreakpoints(const std::set<EntryKind>& kinds) {
    m_breakpoints = kinds;
    if (m_stepper) m_stepper->setBreakpoints(kinds);
    emit changed();
}

QString Stepper::sentence() const {
    if (!m_stepper) return {};
    const std::optional<FrameEntry> entry = m_stepper->current();
    if (!entry) return tr("Nothing was decided and nothing was drawn yet.");
    const EntryNames names = entryNames(m_snapshot, *entry);
    const QString words = translated(entryWords(*entry, names));
    // A frame of a strategy without nodes begins with none of them.
    const bool nodeless = entry->decision && entry->decision->subject.kind == Subject::Kind::Node && m_snapshot.nodes.empty();
    if (!entry->decision || nodeless) return words;
    const QString subject = translated(subjectWords(m_frame->request.strategy->scene(), entry->decision->subject, names));
    return tr("%1: %2", "subject of a decision, what was found").arg(subject, words);
}

}  // namespace cullscope::ui
