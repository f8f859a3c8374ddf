#include "ui/session/view_meter.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/error.h"
#include "core/measure/meter.h"

namespace cullscope::ui {

namespace {

FrameRequest requestOf(int view, const MetricsSubject& what) {
    return {what.buffers, what.strategy, what.culling, what.size, view, what.turn};
}

ViewMetrics failure(const Message& message, const MetricsSubject& subject) {
    ViewMetrics figures;
    figures.state = ViewMetrics::State::Failed;
    figures.failure = message;
    figures.subject = subject;
    return figures;
}

}  // namespace

struct ViewMeter::Bench {
    GpuThread* gpu = nullptr;
    std::unique_ptr<Framebuffer> framebuffer;
    ViewFramesPointer frames;
    std::shared_ptr<StructureStore> structures;
    ViewBaselines baselines;
    References references;

    /// The one of all pictures: a view's memory may hold questions whose answers only their renderer knows.
    Renderer& renderer() { return gpu->renderer(); }
    Framebuffer& target(const Viewport& size) {
        if (!framebuffer || !(framebuffer->size() == size)) framebuffer = std::make_unique<Framebuffer>(size);
        return *framebuffer;
    }

    /// Releases the objects of the context, and references that may have been drawn in a lost context.
    void letGo() {
        framebuffer.reset();
        references.clear();
    }

    /// Drops the references that the newest request does not use.
    void forgetOthers(const std::vector<Subject>& subjects) {
        references.keep([&](const ScenePointer& scene, const Camera& camera, const Viewport& size) {
            return std::ranges::any_of(subjects, [&](const Subject& subject) {
                return subject.what.buffers->scenePointer() == scene && subject.what.culling == camera &&
                       subject.what.size == size;
            });
        });
    }
};

struct ViewMeter::Job {
    std::vector<Subject> subjects;
    uint64_t timing = 0;  ///< ViewMetrics::timing
    std::stop_token stop;
    std::vector<ViewSubject> shown;    ///< of the subjects whose frames were asked for so far
    std::vector<ViewMetrics> figures;  ///< of the same
    std::optional<ViewRounds> rounds;  ///< of all subjects

    /// Asks for the frame that the next subject's view shows. It is decided here where its picture was not drawn yet.
    void askForNext(Bench& bench) {
        const Subject& subject = subjects[shown.size()];
        const MetricsSubject& what = subject.what;
        const FrameRequest request = requestOf(subject.view, what);
        const ViewFramePointer frame = bench.frames->of(request, bench.renderer());
        ViewSubject next{what.buffers, what.strategy, View(what.culling, what.size), {}};
        next.memories.push_back(bench.frames->memoryBefore(request));
        next.shown = {frame, &frame->log};
        const Facing rule = what.strategy->facing();
        next.baseline = bench.baselines.under(rule, what.buffers->scenePointer(), *bench.structures);
        if (rule != Facing::Front)
            next.frontFaces = bench.baselines.under(Facing::Front, what.buffers->scenePointer(), *bench.structures);
        next.limit = bench.baselines.limit(what.buffers->scenePointer(), *bench.structures);
        next.baselineOfLimit = bench.baselines.under(next.limit->facing(), what.buffers->scenePointer(), *bench.structures);
        next.judged = !subject.known;
        shown.push_back(std::move(next));
        figures.push_back(subject.known ? *subject.known : ViewMetrics());
        if (subject.known) return;
        figures.back().subject = what;
        figures.back().frame = frame;
    }
};

TimingProtocol ViewMeter::protocol() {
    TimingProtocol protocol;
    protocol.leastRepetitions = 5;
    protocol.mostRepetitions = 15;
    protocol.budgetSeconds = 1.0;
    return protocol;
}

ViewMeter::ViewMeter(GpuThread& gpu, ViewFramesPointer frames, std::shared_ptr<StructureStore> structures,
                     const TimingProtocol& rounds, QObject* parent)
    : QObject(parent), m_gpu(gpu), m_rounds(rounds), m_bench(std::make_shared<Bench>()) {
    m_bench->gpu = &gpu;
    m_bench->frames = std::move(frames);
    m_bench->structures = std::move(structures);
    connect(
        &gpu, &GpuThread::contextGoing, this, [bench = m_bench] { bench->letGo(); }, Qt::DirectConnection);
}

ViewMeter::~ViewMeter() {
    cancel();
    // What lives on the GPU thread ends there.
    m_gpu.run([this] { *m_bench = Bench(); });
}

size_t ViewMeter::referencesComputed() {
    size_t count = 0;
    m_gpu.run([&] { count = m_bench->references.drawn(); });
    return count;
}

void ViewMeter::deliver(GpuJobs::Step& step, int view, const ViewMetrics& figures) {
    step.deliver([this, view, figures] { emit measured(view, figures); });
}

void ViewMeter::beginAnew() {
    m_stop.request_stop();
    m_stop = std::stop_source();
}

void ViewMeter::cancel() {
    m_jobs.cancel();
    beginAnew();
}

void ViewMeter::leaveOthers(const ScenePointer& scene) {
    cancel();
    // Behind the step in hand, after which nothing of the former request follows.
    m_gpu.post([bench = m_bench, scene] {
        bench->baselines.leaveOthers(scene);
        bench->references.keep([&](const ScenePointer& known, const Camera&, const Viewport&) { return known == scene; });
    });
}

void ViewMeter::measure(std::vector<Subject> subjects) {
    beginAnew();
    // What the loss of the context ends is asked for again with the buffers of the new one.
    std::vector<SceneBuffersPointer> buffers;
    for (const Subject& subject : subjects) buffers.push_back(subject.what.buffers);
    auto job = std::make_shared<Job>();
    job->subjects = std::move(subjects);
    job->timing = ++m_timings;
    job->stop = m_stop.get_token();
    const auto work = [this, job](GpuJobs::Step& step) {
        try {
            measureNext(*job, step);
        } catch (const std::exception& error) {
            // A frame that is not wanted any more has no figures, and there is nothing to tell.
            const auto* known = dynamic_cast<const Error*>(&error);
            if (known != nullptr && known->kind() == ErrorKind::Interrupted) return;
            const Message message = sentenceOf(error, QT_TRANSLATE_NOOP("core", "This view cannot be measured: %1"));
            for (const Subject& subject : job->subjects)
                if (!subject.known) deliver(step, subject.view, failure(message, subject.what));
        }
    };
    m_jobs.start(m_gpu, work, {.buffers = std::move(buffers)});
}

void ViewMeter::measureNext(Job& job, GpuJobs::Step& step) {
    const Renderer::Stoppable stoppable(m_bench->renderer(), job.stop);
    if (!job.rounds) {
        if (job.shown.empty()) m_bench->forgetOthers(job.subjects);
        job.askForNext(*m_bench);
        if (job.shown.size() == job.subjects.size()) job.rounds.emplace(std::move(job.shown), m_rounds);
        return step.again();
    }
    if (!job.rounds->complete()) {
        const auto targetOf = [this](const Viewport& size, size_t) -> Framebuffer& { return m_bench->target(size); };
        if (const auto judged = job.rounds->step(m_bench->renderer(), m_bench->references, targetOf, job.stop)) {
            ViewMetrics& figures = job.figures[*judged];
            static_cast<ViewFigures&>(figures) = job.rounds->figures(*judged);
            figures.state = ViewMetrics::State::Ready;
            deliver(step, job.subjects[*judged].view, figures);
        }
        return step.again();
    }
    for (size_t i = 0; i < job.subjects.size(); ++i) {
        job.rounds->addTimes(i, job.figures[i]);
        job.figures[i].timing = job.timing;
        deliver(step, job.subjects[i].view, job.figures[i]);
    }
}

}  // namespace cullscope::ui
