#include "core/measure/meter.h"

#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/gpu/gpu_frame.h"
#include "core/measure/accuracy.h"
#include "core/measure/statistics.h"

namespace cullscope {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kBuilding = 0.1;  // share of the progress

/// A strategy while it is measured.
struct Contestant {
    StrategyRequest request;
    BuiltStrategyPointer strategy;
    std::vector<ViewStatePointer> states;       ///< by window
    std::vector<ViewStatePointer> left;         ///< the memories after the last counted frame, of a strategy that remembers
    FrameLog log;                               ///< of the first window's last counted frame
    bool askedFor = true;                       ///< false: a baseline measured only for the ratios
    std::vector<double> frameTimes, cullTimes;  ///< of the current pose
    RunMeasurement run;
};

class Experiment {
public:
    Experiment(const MeasureRequest& request, const Progress& progress, const PoseObserver& afterPose)
        : m_request(request),
          m_progress(progress),
          m_afterPose(afterPose),
          m_gl(requireOpenGl45()),
          m_buffers(request.scene, request.upload) {
        for (int window = 0; window < request.windows; ++window) m_targets.push_back(std::make_unique<Framebuffer>(request.size));
        const double step = kBuilding / double(std::max<size_t>(request.strategies.size(), 1));
        for (const StrategyRequest& strategy : request.strategies) {
            if (leftOut(strategy)) continue;
            const double from = step * double(m_contestants.size());
            add(strategy, true, m_progress.part(from, from + step));
        }
        for (const char* baseline : {"all", "backface"})
            if (indexOf(baseline) == m_contestants.size())
                add({baseline, ParameterSet(findStrategy(baseline).info.parameters)}, false, {nullptr, m_progress.stop});
    }

    MeasureResult run() {
        bool interrupted = false;
        const Progress measuring = m_progress.part(kBuilding, 1.0);
        for (size_t pose = 0; pose < m_request.path.poses.size() && !interrupted; ++pose) {
            measuring.tell(double(pose) / double(m_request.path.poses.size()), CULLSCOPE_TR("measuring"));
            interrupted = !measurePose(pose);
            if (!interrupted && m_afterPose) m_afterPose([this] { return resultSoFar(); });
        }
        MeasureResult result = resultSoFar();
        result.interrupted = interrupted;
        return result;
    }

private:
    void add(const StrategyRequest& request, bool askedFor, const Progress& progress) {
        Contestant contestant;
        contestant.request = request;
        contestant.askedFor = askedFor;
        requireAvailable(strategyOf(request).info, m_gl);
        contestant.strategy = buildStrategy(strategyOf(request), request.parameters, m_request.scene, m_structures, progress);
        for (size_t window = 0; window < m_targets.size(); ++window) contestant.states.push_back(contestant.strategy->begin());
        contestant.run.strategy = request;
        contestant.run.promise = contestant.strategy->promise();
        contestant.run.facing = contestant.strategy->facing();
        contestant.run.referenceFacing = contestant.strategy->referenceFacing();
        contestant.run.structure = contestant.strategy->report();
        m_contestants.push_back(std::move(contestant));
    }

    /// Whether this OpenGL cannot run a strategy that may be left out; records why.
    bool leftOut(const StrategyRequest& request) {
        const std::optional<Message> why = unavailable(strategyOf(request).info, m_gl);
        if (!why || !m_request.leaveOutUnavailable) return false;
        m_leftOut.push_back(*why);
        return true;
    }

    /// The index of the first contestant with an id; the number of contestants where there is none.
    [[nodiscard]] size_t indexOf(const std::string& id) const {
        const auto found =
            std::find_if(m_contestants.begin(), m_contestants.end(), [&](const Contestant& c) { return c.request.id == id; });
        return static_cast<size_t>(found - m_contestants.begin());
    }

    /// Draws one frame: each window is culled and drawn; ends when the GPU has finished. `counts`: its times are recorded.
    /// A strategy whose frames depend on the ones before draws every repetition with the memory with which the views came here.
    void drawFrame(Contestant& contestant, const View& view, bool counts) {
        std::vector<ViewStatePointer> arrived;
        if (contestant.strategy->info().remembers)
            for (const ViewStatePointer& state : contestant.states) arrived.push_back(state->clone());
        std::vector<ViewStatePointer>& states = arrived.empty() ? contestant.states : arrived;
        std::vector<std::unique_ptr<GpuFrame>> frames;
        const auto start = Clock::now();
        for (size_t window = 0; window < m_targets.size(); ++window) {
            frames.push_back(std::make_unique<GpuFrame>(m_renderer, m_buffers, view, *m_targets[window], DrawStyle{}));
            contestant.strategy->draw(*frames.back(), *states[window]);
        }
        waitForGpu();
        const double passed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
        if (!counts) return;
        contestant.frameTimes.push_back(passed);
        double cull = 0.0;
        for (const auto& frame : frames) {
            FrameLog log = frame->take();
            cull += log.cullMilliseconds;
            if (frame == frames.front()) contestant.log = std::move(log);
        }
        contestant.cullTimes.push_back(cull);
        contestant.left = std::move(arrived);
    }

    /// Returns false where a stop was requested before the pose was complete.
    bool measurePose(size_t pose) {
        const View view(m_request.path.camera(pose), m_request.size);
        for (Contestant& contestant : m_contestants) {
            contestant.frameTimes.clear();
            contestant.cullTimes.clear();
            for (int i = 0; i < m_request.timing.warmUp; ++i) {
                if (m_progress.stopRequested()) return false;
                drawFrame(contestant, view, false);
            }
        }
        while (!enoughRounds()) {
            for (Contestant& contestant : m_contestants) {
                if (m_progress.stopRequested()) return false;
                drawFrame(contestant, view, true);
            }
        }
        return recordPose(pose, view);
    }

    [[nodiscard]] bool enoughRounds() const {
        const TimingProtocol& timing = m_request.timing;
        const auto rounds = static_cast<int>(m_contestants.front().frameTimes.size());
        if (timing.fixedRepetitions > 0) return rounds >= timing.fixedRepetitions;
        if (rounds >= std::max(1, timing.mostRepetitions)) return true;
        // The median is compared with that of two rounds ago, so at least three rounds are needed.
        if (rounds < std::max(3, timing.leastRepetitions)) return false;
        return std::all_of(m_contestants.begin(), m_contestants.end(), [&](const Contestant& contestant) {
            const double now = quantile(contestant.frameTimes, 0.5);
            if (now > timing.longFrameMilliseconds) return true;
            const std::vector<double> before(contestant.frameTimes.begin(), contestant.frameTimes.end() - 2);
            return std::abs(quantile(before, 0.5) - now) <= timing.steadyWithin * now;
        });
    }

    bool recordPose(size_t pose, const View& view) {
        std::array<std::optional<Reference>, 2> references;
        std::vector<FrameMeasurement> frames;
        for (Contestant& contestant : m_contestants) {
            FrameMeasurement frame;
            frame.pose = pose;
            frame.frameMilliseconds = quantile(contestant.frameTimes, 0.5);
            frame.cullMilliseconds = quantile(contestant.cullTimes, 0.5);
            frame.repetitions = static_cast<int>(contestant.frameTimes.size());
            if (m_progress.stopRequested()) return false;
            if (contestant.strategy->promiseAt(view) == Promise::Approximate) contestant.run.promise = Promise::Approximate;
            const FrameLog& log = contestant.log;
            frame.stages = log.stages;
            frame.consideredTriangles = log.consideredTriangles();
            frame.culledTriangles = log.counters.culledTriangles;
            frame.parts = log.counters.parts;
            frame.figures = log.counters.figures;
            if (m_request.accuracy && contestant.askedFor) {
                std::optional<Reference>& reference = references[contestant.run.referenceFacing == Facing::Front ? 1 : 0];
                if (!reference) reference = itemBufferReference(m_renderer, m_buffers, view, contestant.run.referenceFacing);
                const ShownPixels shown = shownPixels(m_renderer, m_buffers, log, *m_targets.front());
                frame.accuracy = compare(*reference, shown, drawnTriangles(*m_request.scene, log), *m_request.scene);
                frame.ownRaster = !log.drawsScene();
                if (frame.ownRaster || contestant.run.facing != contestant.run.referenceFacing)
                    frame.missedBeyondSnapping = missedBeyondSnapping(*reference, shown, *m_request.scene, view);
            }
            frames.push_back(frame);
        }
        // Only complete poses are kept, so that every ratio has both of its times.
        for (size_t i = 0; i < frames.size(); ++i) {
            m_contestants[i].run.frames.push_back(frames[i]);
            if (!m_contestants[i].left.empty()) m_contestants[i].states = std::move(m_contestants[i].left);
        }
        return true;
    }

    [[nodiscard]] RatioEstimate speedupOver(const char* baseline, const Contestant& contestant) const {
        const std::vector<FrameMeasurement>& slow = m_contestants[indexOf(baseline)].run.frames;
        std::vector<double> ratios;
        for (size_t i = 0; i < contestant.run.frames.size(); ++i)
            ratios.push_back(slow[i].frameMilliseconds / contestant.run.frames[i].frameMilliseconds);
        return bootstrapMean(ratios);
    }

    /// The poses measured completely so far, with their summaries; `interrupted` while poses are missing.
    [[nodiscard]] MeasureResult resultSoFar() const {
        MeasureResult result;
        result.request = m_request;
        result.gl = m_gl;
        result.leftOut = m_leftOut;
        result.interrupted = m_contestants.front().run.frames.size() < m_request.path.poses.size();
        for (const Contestant& contestant : m_contestants) {
            if (!contestant.askedFor) continue;
            result.runs.push_back(contestant.run);
            result.runs.back().summary = summaryOf(contestant);
        }
        return result;
    }

    [[nodiscard]] Summary summaryOf(const Contestant& contestant) const {
        const std::vector<FrameMeasurement>& frames = contestant.run.frames;
        Summary summary;
        if (frames.empty()) return summary;
        std::vector<double> times;
        double cull = 0.0, considered = 0.0;
        for (const FrameMeasurement& frame : frames) {
            times.push_back(frame.frameMilliseconds);
            cull += frame.cullMilliseconds;
            considered += double(frame.consideredTriangles);
            summary.fpsMean += 1000.0 / frame.frameMilliseconds / double(frames.size());
        }
        const double total = std::accumulate(times.begin(), times.end(), 0.0);
        summary.fpsOverall = 1000.0 * double(frames.size()) / total;
        summary.fpsMin = 1000.0 / *std::max_element(times.begin(), times.end());
        summary.fpsMax = 1000.0 / *std::min_element(times.begin(), times.end());
        summary.frameMillisecondsMedian = quantile(times, 0.5);
        summary.frameMillisecondsP95 = quantile(times, 0.95);
        summary.frameMillisecondsP99 = quantile(times, 0.99);
        summary.cullShare = cull / total;
        const double triangles = double(m_request.scene->triangleCount());
        summary.culledFraction = triangles > 0 ? 1.0 - considered / double(frames.size()) / triangles : 0.0;
        if (const std::optional<Losses> lost = contestant.run.losses())
            summary.missedPixelRate = lost->coveredPixels > 0 ? double(lost->missedPixels) / double(lost->coveredPixels) : 0.0;
        const RatioEstimate all = speedupOver("all", contestant);
        summary.speedupVsAll = all.mean;
        summary.speedupVsAllCi95 = all.ci95;
        const RatioEstimate backface = speedupOver("backface", contestant);
        summary.speedupVsBackface = backface.mean;
        summary.speedupVsBackfaceCi95 = backface.ci95;
        return summary;
    }

    const MeasureRequest& m_request;
    const Progress& m_progress;
    const PoseObserver& m_afterPose;
    GlInfo m_gl;
    Renderer m_renderer;
    SceneBuffers m_buffers;
    std::vector<std::unique_ptr<Framebuffer>> m_targets;
    StructureStore m_structures;
    std::vector<Contestant> m_contestants;
    std::vector<Message> m_leftOut;
};

}  // namespace

std::optional<Losses> RunMeasurement::losses() const {
    if (frames.empty() || !frames.front().accuracy) return std::nullopt;
    Losses losses;
    uint64_t most = 0;
    for (const FrameMeasurement& frame : frames) {
        losses.coveredPixels += frame.accuracy->coveredPixels;
        losses.missedPixels += frame.accuracy->missedPixels;
        losses.missedBeyondSnapping += frame.missedBeyondSnapping;
        losses.largestHolePixels = std::max(losses.largestHolePixels, frame.accuracy->largestHolePixels);
        if (frame.accuracy->missedPixels <= most) continue;
        most = frame.accuracy->missedPixels;
        losses.worstPose = frame.pose;
    }
    return losses;
}

bool RunMeasurement::promiseBroken() const {
    if (promise == Promise::Approximate) return false;
    return std::any_of(frames.begin(), frames.end(), [&](const FrameMeasurement& frame) {
        if (frame.ownRaster || facing != referenceFacing) return frame.missedBeyondSnapping > 0;
        return frame.accuracy && frame.accuracy->missedPixels > 0;
    });
}

MeasureResult measure(const MeasureRequest& request, const Progress& progress, const PoseObserver& afterPose) {
    if (request.strategies.empty()) throwUsage(CULLSCOPE_TR("No strategy is named: give one with -s."));
    if (request.path.poses.empty()) throwUsage(CULLSCOPE_TR("The camera path has no poses."));
    if (request.scene->triangleCount() == 0) throwUsage(CULLSCOPE_TR("The scene has no triangles: there is nothing to measure."));
    return Experiment(request, progress, afterPose).run();
}

}  // namespace cullscope
