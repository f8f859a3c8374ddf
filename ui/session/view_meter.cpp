#include "ui/session/view_meter.h"

#include <QCoreApplication>
#include <chrono>
#include <map>

#include "core/base/error.h"
#include "core/measure/accuracy.h"
#include "core/measure/render_frame.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr const char* kBaseline = "backface";

/// One strategy to be timed; several views may share it.
struct Runner {
    MetricsSubject what;
    ViewStatePointer state;  ///< the memory with which the next frame begins
    std::vector<double> frameTimes, cullTimes;
};

bool sameWork(const MetricsSubject& a, const MetricsSubject& b) {
    return a.buffers == b.buffers && a.culling == b.culling && a.size == b.size && a.strategy->id() == b.strategy->id() &&
           a.strategy->parameters() == b.strategy->parameters();
}

/// The index of the runner for this work, which is added if there is none. Work of a view with a memory is its own.
size_t runnerFor(std::vector<Runner>& runners, const MetricsSubject& what, ViewStatePointer state) {
    for (size_t i = 0; i < runners.size() && !what.strategy->info().remembers; ++i)
        if (sameWork(runners[i].what, what)) return i;
    runners.push_back({what, std::move(state), {}, {}});
    return runners.size() - 1;
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

void fillTimes(ViewMetrics& figures, const Runner& runner, const Runner& baseline) {
    figures.frameMilliseconds = median(runner.frameTimes);
    figures.cullMilliseconds = median(runner.cullTimes);
    figures.timed = true;
    std::vector<double> ratios;
    for (size_t i = 0; i < runner.frameTimes.size(); ++i)
        if (runner.frameTimes[i] > 0.0) ratios.push_back(baseline.frameTimes[i] / runner.frameTimes[i]);
    if (!ratios.empty()) figures.speedup = median(ratios);
}

}  // namespace

struct ViewMeter::Bench {
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<Framebuffer> framebuffer;
    ViewFramesPointer frames;
    std::shared_ptr<StructureStore> structures;
    BuiltStrategyPointer baseline;

    struct KnownReference {
        ScenePointer scene;
        Camera camera;
        std::shared_ptr<const Reference> truth;
    };
    std::vector<KnownReference> references;
    size_t referencesComputed = 0;

    Framebuffer& target(const Viewport& size) {
        if (!renderer) renderer = std::make_unique<Renderer>();
        if (!framebuffer || !(framebuffer->size() == size)) framebuffer = std::make_unique<Framebuffer>(size);
        return *framebuffer;
    }

    /// Releases the objects of the context, and references that may have been drawn in a lost context.
    void letGo() {
        renderer.reset();
        framebuffer.reset();
        references.clear();
    }

    /// Drops the references that the newest request does not use.
    void forgetOthers(const std::vector<Subject>& subjects) {
        std::erase_if(references, [&](const KnownReference& known) {
            return std::none_of(subjects.begin(), subjects.end(), [&](const Subject& subject) {
                return subject.what.buffers->scenePointer() == known.scene && subject.what.culling == known.camera &&
                       subject.what.size == known.truth->size;
            });
        });
    }

    std::shared_ptr<const Reference> reference(const SceneBuffers& buffers, const View& view, Facing facing) {
        for (const KnownReference& known : references)
            if (known.scene == buffers.scenePointer() && known.camera == view.camera() && known.truth->size == view.viewport() &&
                known.truth->facing == facing)
                return known.truth;
        ++referencesComputed;
        auto truth = std::make_shared<const Reference>(itemBufferReference(*renderer, buffers, view, facing));
        references.push_back({buffers.scenePointer(), view.camera(), truth});
        return truth;
    }

    FrameResult draw(Runner& runner) {
        const MetricsSubject& what = runner.what;
        Framebuffer& into = target(what.size);
        // Every frame of a view with a memory begins with the one that the view had.
        const ViewStatePointer own = what.strategy->info().remembers ? runner.state->clone() : nullptr;
        ViewState& state = own ? *own : *runner.state;
        return renderFrame(*renderer, *what.buffers, *what.strategy, state, View(what.culling, what.size), into);
    }

    /// All metrics of a view's frame but its speed.
    ViewMetrics accuracy(int number, const MetricsSubject& what) {
        const View view(what.culling, what.size);
        const Scene& scene = what.buffers->scene();
        Framebuffer& into = target(what.size);
        const ViewFramePointer frame =
            frames->of({what.buffers, what.strategy, what.culling, what.size, number}, true, *renderer);
        const FrameLog& log = frame->log;
        ViewMetrics figures;
        figures.promise = what.strategy->promiseAt(view);
        figures.state = ViewMetrics::State::Ready;
        figures.subject = what;
        figures.cullMilliseconds = log.cullMilliseconds;
        figures.consideredTriangles = log.consideredTriangles();
        figures.sceneTriangles = scene.triangleCount();
        figures.facing = log.facing;
        figures.size = view.viewport();
        const ShownPixels shown = shownPixels(*renderer, *what.buffers, log, into);
        const auto truth = reference(*what.buffers, view, what.strategy->referenceFacing());
        figures.accuracy = compare(*truth, shown, drawnTriangles(scene, log), scene);
        if (figures.facing != truth->facing) figures.missedBeyondSnapping = missedBeyondSnapping(*truth, shown, scene, view);
        figures.states = std::make_shared<const TriangleStates>(triangleStates(scene, log, truth->visible()));
        const std::vector<uint8_t> missed = missedMask(*truth, shown);
        figures.lostObjects = lostObjects(scene, *truth, missed);
        figures.holes = holes(missed, truth->size);
        return figures;
    }

    BuiltStrategyPointer baselineFor(const ScenePointer& scene) {
        if (!baseline || baseline->scenePointer() != scene)
            baseline = buildStrategy(kBaseline, ParameterSet(findStrategy(kBaseline).info.parameters), scene, *structures);
        return baseline;
    }
};

struct ViewMeter::Job {
    Rounds rounds;
    std::vector<Subject> subjects;
    std::vector<ViewMetrics> figures;
    std::vector<Runner> runners;
    std::vector<std::pair<size_t, size_t>> places;  ///< indices of a subject's runner and of its baseline's
    int round = -1;                                 ///< number of the round; round -1 is a warm-up
    size_t place = 0;                               ///< index of the next runner in the round
    double spent = 0.0;                             ///< seconds of drawing

    void prepareTiming(Bench& bench) {
        for (const Subject& subject : subjects) {
            MetricsSubject baseline = subject.what;
            baseline.strategy = bench.baselineFor(subject.what.buffers->scenePointer());
            const size_t baselinePlace = runnerFor(runners, baseline, baseline.strategy->begin());
            const MetricsSubject& what = subject.what;
            ViewStatePointer memory =
                bench.frames->memoryBefore({what.buffers, what.strategy, what.culling, what.size, subject.view});
            places.emplace_back(runnerFor(runners, what, std::move(memory)), baselinePlace);
        }
    }

    /// Times one frame; returns false if the measurement is complete.
    bool timeOne(Bench& bench) {
        // Every other round runs in reverse order, so that no strategy always follows the same one.
        Runner& runner = runners[round % 2 == 0 ? place : runners.size() - 1 - place];
        const FrameResult frame = bench.draw(runner);
        spent += frame.frameMilliseconds / 1000.0;
        if (round >= 0) {
            runner.frameTimes.push_back(frame.frameMilliseconds);
            runner.cullTimes.push_back(frame.log.cullMilliseconds);
        }
        if (++place < runners.size()) return true;
        place = 0;
        ++round;
        return round < rounds.most && (round < rounds.fewest || spent < rounds.budgetSeconds);
    }
};

ViewMeter::ViewMeter(GpuThread& gpu, ViewFramesPointer frames, std::shared_ptr<StructureStore> structures, const Rounds& rounds,
                     QObject* parent)
    : QObject(parent), m_gpu(gpu), m_rounds(rounds), m_bench(std::make_shared<Bench>()) {
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
    m_gpu.run([&] { count = m_bench->referencesComputed; });
    return count;
}

void ViewMeter::deliver(GpuJobs::Step& step, int view, const ViewMetrics& figures) {
    step.deliver([this, view, figures] { emit measured(view, figures); });
}

void ViewMeter::measure(std::vector<Subject> subjects) {
    // What the loss of the context ends is asked for again with the buffers of the new one.
    std::vector<SceneBuffersPointer> buffers;
    for (const Subject& subject : subjects) buffers.push_back(subject.what.buffers);
    auto job = std::make_shared<Job>();
    job->subjects = std::move(subjects);
    job->rounds = m_rounds;
    const auto work = [this, job](GpuJobs::Step& step) {
        try {
            measureNext(*job, step);
        } catch (const std::exception& error) {
            const Message message = sentenceOf(error, QT_TRANSLATE_NOOP("core", "This view cannot be measured: %1"));
            for (const Subject& subject : job->subjects) deliver(step, subject.view, failure(message, subject.what));
        }
    };
    m_jobs.start(m_gpu, work, {.buffers = std::move(buffers)});
}

void ViewMeter::measureNext(Job& job, GpuJobs::Step& step) {
    if (job.figures.empty()) m_bench->forgetOthers(job.subjects);
    if (job.figures.size() < job.subjects.size()) {
        const Subject& subject = job.subjects[job.figures.size()];
        job.figures.push_back(m_bench->accuracy(subject.view, subject.what));
        deliver(step, subject.view, job.figures.back());
        if (job.figures.size() == job.subjects.size()) job.prepareTiming(*m_bench);
        return step.again();
    }
    if (job.timeOne(*m_bench)) return step.again();
    for (size_t i = 0; i < job.subjects.size(); ++i) {
        fillTimes(job.figures[i], job.runners[job.places[i].first], job.runners[job.places[i].second]);
        deliver(step, job.subjects[i].view, job.figures[i]);
    }
}

}  // namespace cullscope::ui
