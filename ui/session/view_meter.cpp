#include "ui/session/view_meter.h"

#include <QCoreApplication>
#include <algorithm>
#include <map>

#include "core/base/error.h"
#include "core/measure/meter.h"

namespace cullscope::ui {

namespace {

bool sameWork(const MetricsSubject& a, const MetricsSubject& b) {
    return a.buffers == b.buffers && a.culling == b.culling && a.size == b.size && a.strategy->id() == b.strategy->id() &&
           a.strategy->parameters() == b.strategy->parameters();
}

FrameRequest requestOf(int view, const MetricsSubject& what) {
    return {what.buffers, what.strategy, what.culling, what.size, view};
}

std::vector<LostObject> lostObjects(const Scene& scene, const Reference& truth, const std::vector<uint8_t>& missed) {
    std::map<uint32_t, uint64_t> pixels;
    for (size_t i = 0; i < missed.size(); ++i)
        if (missed[i] != 0 && truth.triangle[i] != 0) ++pixels[uint32_t(scene.instanceOf(truth.triangle[i] - 1))];
    std::vector<LostObject> objects;
    for (const auto& [instance, count] : pixels) objects.push_back({instance, count});
    std::stable_sort(objects.begin(), objects.end(), [](const auto& a, const auto& b) { return a.pixels > b.pixels; });
    return objects;
}

ViewMetrics failure(const Message& message, const MetricsSubject& subject) {
    ViewMetrics figures;
    figures.state = ViewMetrics::State::Failed;
    figures.failure = message;
    figures.subject = subject;
    return figures;
}

void fillTimes(ViewMetrics& figures, const FrameMeasurement& subject, const FrameMeasurement& baseline) {
    figures.frameMilliseconds = subject.frameMilliseconds;
    figures.cullMilliseconds = subject.cullMilliseconds;
    figures.timed = true;
    figures.speedup = ratioOver({&baseline, 1}, {&subject, 1});
}

}  // namespace

struct ViewMeter::Bench {
    GpuThread* gpu = nullptr;
    std::unique_ptr<Framebuffer> framebuffer;
    ViewFramesPointer frames;
    std::shared_ptr<StructureStore> structures;
    BuiltStrategyPointer baseline;

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

    /// All metrics of a view's timed frame but its speed. Only the colours by verdict are of the frame that the view shows: they
    /// need its decisions, which timed frames do not record.
    ViewMetrics accuracy(int number, const MetricsSubject& what, const TimedFrames& timed) {
        const Scene& scene = what.buffers->scene();
        const auto truth = references.of(renderer(), *timed.buffers, timed.view, what.strategy->referenceFacing());
        FrameMeasurement measured = measurementOf(timed);
        const JudgedFrame judged = addLosses(measured, renderer(), timed, *truth, target(what.size));
        ViewMetrics figures;
        figures.promise = what.strategy->promiseAt(timed.view);
        figures.state = ViewMetrics::State::Ready;
        figures.subject = what;
        figures.cullMilliseconds = measured.cullMilliseconds;
        figures.submitted = measured.submitted;
        figures.consideredTriangles = measured.consideredTriangles;
        figures.sceneTriangles = scene.triangleCount();
        figures.size = what.size;
        figures.truthFacing = truth->facing;
        figures.accuracy = judged.accuracy;
        figures.missedBeyondSnapping = judged.missedBeyondSnapping;
        const std::vector<uint8_t> missed = missedMask(*truth, judged.shown);
        figures.lostObjects = lostObjects(scene, *truth, missed);
        figures.holes = holes(missed, truth->size);
        const ViewFramePointer shown = frames->of(requestOf(number, what), renderer());
        figures.states = std::make_shared<const TriangleStates>(triangleStates(scene, shown->log, truth->visible()));
        return figures;
    }

    const BuiltStrategyPointer& baselineFor(const ScenePointer& scene) {
        if (!baseline || baseline->scenePointer() != scene)
            baseline = baselinesBeside({}, scene, *structures, BaselineRole::FrontFaces).front().strategy;
        return baseline;
    }
};

struct ViewMeter::Job {
    /// Numbers of a subject's frames among those that are timed.
    struct Place {
        size_t subject = 0, baseline = 0;
    };

    std::vector<Subject> subjects;
    std::stop_token stop;
    std::vector<ViewMetrics> figures;
    std::optional<TimedRounds> rounds;
    std::vector<Place> places;

    void prepareTiming(Bench& bench, const TimingProtocol& protocol) {
        std::vector<MetricsSubject> works;
        std::vector<TimedFrames> timed;
        // Several views may share the same work; that of a view with a memory is its own.
        const auto placeOf = [&](const MetricsSubject& what, ViewStatePointer memory) {
            for (size_t i = 0; i < works.size() && !what.strategy->info().remembers; ++i)
                if (sameWork(works[i], what)) return i;
            works.push_back(what);
            timed.push_back({what.buffers.get(), what.strategy, View(what.culling, what.size), {}});
            timed.back().memories.push_back(std::move(memory));
            return works.size() - 1;
        };
        for (const Subject& subject : subjects) {
            const MetricsSubject& what = subject.what;
            MetricsSubject baseline = what;
            baseline.strategy = bench.baselineFor(what.buffers->scenePointer());
            const size_t baselinePlace = placeOf(baseline, baseline.strategy->begin());
            // What a view remembers is known when its frame is decided.
            const FrameRequest frame = requestOf(subject.view, what);
            if (what.strategy->info().remembers) (void)bench.frames->of(frame, bench.renderer());
            ViewStatePointer memory = bench.frames->memoryBefore(frame);
            places.push_back({placeOf(what, std::move(memory)), baselinePlace});
        }
        rounds.emplace(std::move(timed), protocol);
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

void ViewMeter::measure(std::vector<Subject> subjects) {
    beginAnew();
    // What the loss of the context ends is asked for again with the buffers of the new one.
    std::vector<SceneBuffersPointer> buffers;
    for (const Subject& subject : subjects) buffers.push_back(subject.what.buffers);
    auto job = std::make_shared<Job>();
    job->subjects = std::move(subjects);
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
    if (!job.rounds) {
        m_bench->forgetOthers(job.subjects);
        job.prepareTiming(*m_bench, m_rounds);
    }
    const std::vector<TimedFrames>& timed = job.rounds->entrants();
    // The errors are those of the first frames that are timed, so they are known before the speeds are steady.
    if (job.rounds->counted() && job.figures.size() < job.subjects.size()) {
        const Subject& next = job.subjects[job.figures.size()];
        if (next.known) {
            job.figures.push_back(*next.known);
        } else {
            job.figures.push_back(m_bench->accuracy(next.view, next.what, timed[job.places[job.figures.size()].subject]));
            deliver(step, next.view, job.figures.back());
        }
        return step.again();
    }
    if (!job.rounds->complete()) {
        job.rounds->step(
            m_bench->renderer(), [this](const Viewport& size, size_t) -> Framebuffer& { return m_bench->target(size); },
            job.stop);
        return step.again();
    }
    for (size_t i = 0; i < job.subjects.size(); ++i) {
        fillTimes(job.figures[i], measurementOf(timed[job.places[i].subject]), measurementOf(timed[job.places[i].baseline]));
        deliver(step, job.subjects[i].view, job.figures[i]);
    }
}

}  // namespace cullscope::ui
