#include "ui/session/figure_meter.h"

#include <QCoreApplication>
#include <chrono>
#include <optional>

#include "core/base/error.h"
#include "core/measure/frame.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr int kFewestRounds = 3;
constexpr int kMostRounds = 15;
constexpr double kTimingBudget = 1.0;  // seconds, after which no further round is begun

constexpr const char* kBaseline = "backface";

/// One strategy to be timed; several views may share it.
struct Runner {
    BuiltStrategyPointer strategy;
    Viewport size;
    std::vector<double> frameTimes, cullTimes;
};

bool sameWork(const BuiltStrategy& a, const BuiltStrategy& b) {
    return a.id == b.id && a.strategy->parameters() == b.strategy->parameters();
}

}  // namespace

struct FigureMeter::Bench {
    std::unique_ptr<Renderer> renderer;
    std::unique_ptr<Framebuffer> framebuffer;
    BuiltStrategyPointer baseline;

    ScenePointer referenceScene;
    Camera referenceCamera;
    std::vector<Reference> references;  ///< all of the camera above
    size_t referencesComputed = 0;

    Framebuffer& target(const Viewport& size) {
        if (!framebuffer || !(framebuffer->size() == size)) framebuffer = std::make_unique<Framebuffer>(size);
        return *framebuffer;
    }

    const Reference& reference(const SceneBuffers& buffers, const View& view, Facing facing) {
        if (referenceScene != buffers.scenePointer() || !(referenceCamera == view.camera())) references.clear();
        referenceScene = buffers.scenePointer();
        referenceCamera = view.camera();
        for (const Reference& known : references)
            if (known.size == view.viewport() && known.facing == facing) return known;
        ++referencesComputed;
        references.push_back(itemBufferReference(*renderer, buffers, view, facing));
        return references.back();
    }

    FrameResult draw(const SceneBuffers& buffers, BuiltStrategy& built, const View& view) {
        return renderShared(*renderer, buffers, built, view, target(view.viewport()));
    }

    /// Everything of `figures` that is not a ratio.
    Figures accuracy(const SceneBuffers& buffers, BuiltStrategy& built, const View& view) {
        const FrameResult frame = draw(buffers, built, view);
        Figures figures;
        figures.state = Figures::State::Ready;
        figures.frameMilliseconds = frame.frameMilliseconds;
        figures.cullMilliseconds = frame.verdict.cullMilliseconds;
        figures.consideredTriangles = frame.verdict.consideredTriangles;
        figures.sceneTriangles = buffers.scene().triangleCount();
        figures.facing = frame.verdict.drawList.facing;
        figures.size = view.viewport();
        const std::vector<float> depth = framebuffer->readDepth();
        const Reference& truth = reference(buffers, view, built.strategy->referenceFacing());
        figures.accuracy = compare(truth, depth, frame.verdict.drawList, buffers.scene());
        if (figures.facing != truth.facing)
            figures.missedBeyondSnapping = missedBeyondSnapping(truth, depth, buffers.scene(), view);
        return figures;
    }

    BuiltStrategyPointer baselineFor(const ScenePointer& scene) {
        if (!baseline || baseline->scene != scene) {
            auto made = std::make_shared<BuiltStrategy>();
            made->id = kBaseline;
            made->scene = scene;
            made->strategy = makeStrategy(kBaseline);
            made->strategy->build(*scene);
            baseline = made;
        }
        return baseline;
    }

    /// The runner for this work, made where there is none yet.
    static size_t runnerFor(std::vector<Runner>& runners, const BuiltStrategyPointer& strategy, const Viewport& size) {
        for (size_t i = 0; i < runners.size(); ++i)
            if (runners[i].size == size && sameWork(*runners[i].strategy, *strategy)) return i;
        runners.push_back({strategy, size, {}, {}});
        return runners.size() - 1;
    }

    /// Interleaved rounds over all runners; false where `wanted` turned false on the way.
    template <typename Wanted>
    bool time(const SceneBuffers& buffers, const Camera& camera, std::vector<Runner>& runners, const Wanted& wanted) {
        using Clock = std::chrono::steady_clock;
        const Clock::time_point begin = Clock::now();
        for (int round = -1; round < kMostRounds; ++round) {
            const double elapsed = std::chrono::duration<double>(Clock::now() - begin).count();
            if (round >= kFewestRounds && elapsed > kTimingBudget) break;
            for (size_t place = 0; place < runners.size(); ++place) {
                if (!wanted()) return false;
                // Every other round runs backwards, so that none profits from always coming after the same one.
                Runner& runner = runners[round % 2 == 0 ? place : runners.size() - 1 - place];
                const FrameResult frame = draw(buffers, *runner.strategy, View(camera, runner.size));
                if (round < 0) continue;  // the first round warms up
                runner.frameTimes.push_back(frame.frameMilliseconds);
                runner.cullTimes.push_back(frame.verdict.cullMilliseconds);
            }
        }
        return true;
    }
};

namespace {

void fillTimes(Figures& figures, const Runner& runner, const Runner& baseline) {
    figures.frameMilliseconds = median(runner.frameTimes);
    figures.cullMilliseconds = median(runner.cullTimes);
    std::vector<double> ratios;
    for (size_t i = 0; i < runner.frameTimes.size(); ++i)
        if (runner.frameTimes[i] > 0.0) ratios.push_back(baseline.frameTimes[i] / runner.frameTimes[i]);
    if (!ratios.empty()) figures.speedup = median(ratios);
}

Figures failure(const Message& message) {
    Figures figures;
    figures.state = Figures::State::Failed;
    figures.failure = message;
    return figures;
}

}  // namespace

FigureMeter::FigureMeter(GpuThread& gpu, QObject* parent) : QObject(parent), m_gpu(gpu), m_bench(std::make_shared<Bench>()) {
    m_gpu.post([bench = m_bench] { bench->renderer = std::make_unique<Renderer>(); });
}

FigureMeter::~FigureMeter() {
    cancel();
    // What lives on the GPU thread ends there.
    m_gpu.run([this] { *m_bench = Bench(); });
}

size_t FigureMeter::referencesComputed() {
    size_t count = 0;
    m_gpu.run([&] { count = m_bench->referencesComputed; });
    return count;
}

void FigureMeter::deliver(uint64_t job, int view, const Figures& figures) {
    QMetaObject::invokeMethod(
        this,
        [this, job, view, figures] {
            if (m_jobs.isCurrent(job)) emit measured(view, figures);
        },
        Qt::QueuedConnection);
}

void FigureMeter::measure(const SceneBuffersPointer& buffers, const Camera& camera, std::vector<Subject> subjects) {
    const uint64_t job = m_jobs.begin();
    m_gpu.post([this, job, buffers, camera, subjects = std::move(subjects)] {
        const auto wanted = [&] { return m_jobs.isCurrent(job); };
        std::vector<Figures> figures(subjects.size());
        try {
            for (size_t i = 0; i < subjects.size(); ++i) {
                if (!wanted()) return;
                figures[i] = m_bench->accuracy(*buffers, *subjects[i].strategy, View(camera, subjects[i].size));
            }
            std::vector<Runner> runners;
            std::vector<std::pair<size_t, size_t>> places;  // of the subject and of its baseline
            for (const Subject& subject : subjects) {
                const size_t baseline = Bench::runnerFor(runners, m_bench->baselineFor(buffers->scenePointer()), subject.size);
                places.emplace_back(Bench::runnerFor(runners, subject.strategy, subject.size), baseline);
            }
            if (!m_bench->time(*buffers, camera, runners, wanted)) return;
            for (size_t i = 0; i < subjects.size(); ++i) {
                fillTimes(figures[i], runners[places[i].first], runners[places[i].second]);
                deliver(job, subjects[i].view, figures[i]);
            }
        } catch (const Error& error) {
            for (const Subject& subject : subjects) deliver(job, subject.view, failure(error.message()));
        } catch (const std::exception& error) {
            const Message message{QT_TRANSLATE_NOOP("core", "This view cannot be measured: %1"), {error.what()}};
            for (const Subject& subject : subjects) deliver(job, subject.view, failure(message));
        }
    });
}

}  // namespace cullscope::ui
