#include "core/measure/meter.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "core/base/error.h"
#include "core/measure/summary.h"
#include "core/measure/view_rounds.h"

namespace cullscope {
namespace {

constexpr double kBuilding = 0.1;  // share of the progress

void requireSomething(const MeasureRequest& request) {
    if (request.strategies.empty() && !request.baselinesToo) throwUsage(CULLSCOPE_TR("No strategy is named: give one with -s."));
    if (request.path.poses.empty()) throwUsage(CULLSCOPE_TR("The camera path has no poses."));
    if (request.scene->triangleCount() == 0) throwUsage(CULLSCOPE_TR("The scene has no triangles: there is nothing to measure."));
}

/// Whether the measurement goes on after an error of one strategy.
bool isRefusal(const Error& error, const MeasureRequest& request) {
    return request.refusalsAreResults && error.kind() != ErrorKind::Interrupted;
}

/// Adds the baselines that draw by the facing rules of the strategies, where they are not there yet.
void addOwnRules(std::vector<Contestant>& strategies, const ScenePointer& scene, StructureStore& structures,
                 const Progress& progress) {
    std::set<Facing> rules;
    for (const Contestant& contestant : strategies) rules.insert(contestant.strategy->facing());
    for (const Facing rule : rules) {
        const StrategyRequest baseline = baselineUnder(rule);
        if (std::ranges::find(strategies, baseline, &Contestant::request) != strategies.end()) continue;
        strategies.push_back(
            {baseline, buildStrategy(strategyOf(baseline), baseline.parameters, scene, structures, progress), false});
    }
}

StrategyRequest limitAtDefaults() {
    const StrategyInfo& info = limitOfCulling();
    return {info.id, ParameterSet(info.parameters)};
}

/// Adds the limit of culling, where it is not there yet and this OpenGL can run it.
void addLimit(std::vector<Contestant>& strategies, const MeasureRequest& request, const GlInfo& gl, StructureStore& structures,
              const Progress& progress) {
    const StrategyRequest limit = limitAtDefaults();
    if (std::ranges::find(strategies, limit, &Contestant::request) != strategies.end()) return;
    if (unavailable(limitOfCulling(), gl)) return;
    strategies.push_back(
        {limit, buildStrategy(strategyOf(limit), limit.parameters, request.scene, structures, progress), request.baselinesToo});
}

/// `built`, of that scene.
const BuiltStrategyPointer& builtFor(const ScenePointer& scene, BuiltStrategyPointer& built, const StrategyRequest& request,
                                     StructureStore& structures) {
    if (!built || built->scenePointer() != scene)
        built = buildStrategy(strategyOf(request), request.parameters, scene, structures);
    return built;
}

/// How many numbers are in one of two ascending lists and not in the other.
uint64_t differentNumbers(const std::vector<uint32_t>& one, const std::vector<uint32_t>& other) {
    std::vector<uint32_t> different;
    std::ranges::set_symmetric_difference(one, other, std::back_inserter(different));
    return different.size();
}

}  // namespace

std::vector<Contestant> baselinesBeside(const std::vector<StrategyRequest>& strategies, const ScenePointer& scene,
                                        StructureStore& structures, std::optional<BaselineRole> role, const Progress& progress) {
    std::vector<Contestant> built;
    for (const StrategyRequest& baseline : missingBaselines(strategies)) {
        const RegisteredStrategy& strategy = strategyOf(baseline);
        if (role && strategy.info.baseline != *role) continue;
        built.push_back({baseline, buildStrategy(strategy, baseline.parameters, scene, structures, progress), false});
    }
    return built;
}

const BuiltStrategyPointer& ViewBaselines::under(Facing rule, const ScenePointer& scene, StructureStore& structures) {
    return builtFor(scene, m_built[size_t(rule)], baselineUnder(rule), structures);
}

const BuiltStrategyPointer& ViewBaselines::limit(const ScenePointer& scene, StructureStore& structures) {
    return builtFor(scene, m_limit, limitAtDefaults(), structures);
}

void ViewBaselines::leaveOthers(const ScenePointer& scene) {
    for (BuiltStrategyPointer& built : m_built)
        if (built && built->scenePointer() != scene) built.reset();
    if (m_limit && m_limit->scenePointer() != scene) m_limit.reset();
}

Contestants buildContestants(const MeasureRequest& request, const GlInfo& gl, StructureStore& structures,
                             const Progress& progress) {
    requireSomething(request);
    Contestants built;
    const double step = 1.0 / double(std::max<size_t>(1, request.strategies.size()));
    for (const StrategyRequest& strategy : request.strategies) {
        const std::optional<Message> why = unavailable(strategyOf(strategy).info, gl);
        if (why && request.leaveOutUnavailable && !request.refusalsAreResults) {
            built.leftOut.push_back(*why);
            continue;
        }
        const double from = step * double(built.strategies.size());
        try {
            requireAvailable(strategyOf(strategy).info, gl);
            built.strategies.push_back({strategy, buildStrategy(strategyOf(strategy), strategy.parameters, request.scene,
                                                                structures, progress.part(from, from + step))});
        } catch (const Error& error) {
            if (!isRefusal(error, request)) throw;
            built.refused.push_back({strategy, error.message()});
        }
    }
    for (Contestant& baseline :
         baselinesBeside(request.strategies, request.scene, structures, std::nullopt, {nullptr, progress.stop})) {
        baseline.askedFor = request.baselinesToo;
        built.strategies.push_back(std::move(baseline));
    }
    if (request.limitToo) addLimit(built.strategies, request, gl, structures, {nullptr, progress.stop});
    addOwnRules(built.strategies, request.scene, structures, {nullptr, progress.stop});
    return built;
}

/// The steps of a measurement, pose by pose.
class Meter::Experiment {
public:
    Experiment(const MeasureRequest& request, Contestants contestants, const GlInfo& gl,
               std::shared_ptr<const SceneBuffers> buffers)
        : m_request(request), m_contestants(std::move(contestants)), m_gl(gl), m_buffers(std::move(buffers)) {
        // The result's request names all strategies that it has runs of.
        if (request.baselinesToo)
            for (StrategyRequest& baseline : missingBaselines(request.strategies))
                m_request.strategies.push_back(std::move(baseline));
        if (request.limitToo && request.baselinesToo &&
            std::ranges::find(request.strategies, limitAtDefaults()) == request.strategies.end())
            m_request.strategies.push_back(limitAtDefaults());
        for (int window = 0; window < request.windows; ++window) m_targets.push_back(std::make_unique<Framebuffer>(request.size));
        for (const Contestant& contestant : m_contestants.strategies) {
            m_memories.emplace_back();
            for (size_t window = 0; window < m_targets.size(); ++window)
                m_memories.back().push_back(contestant.strategy->begin());
            RunMeasurement run;
            run.strategy = contestant.request;
            run.promise = contestant.strategy->promise();
            run.facing = contestant.strategy->facing();
            run.referenceFacing = contestant.strategy->referenceFacing();
            run.ownRule = baselineUnder(run.facing);
            run.structure = contestant.strategy->report();
            m_runs.push_back(std::move(run));
            m_taking.push_back({});
            m_lost.emplace_back();
        }
    }

    [[nodiscard]] size_t poses() const { return m_poses; }
    [[nodiscard]] bool complete() const { return poses() == m_request.path.poses.size(); }

    void step(const std::stop_token& stop) {
        if (complete()) return;
        if (!m_pose) beginPose();
        if (!m_pose->rounds.complete()) measureNext(stop);
        if (m_pose->rounds.complete()) endPose();
    }

    [[nodiscard]] MeasureResult resultSoFar() const {
        MeasureResult result;
        result.request = m_request;
        result.gl = m_gl;
        result.leftOut = m_contestants.leftOut;
        result.refused = m_contestants.refused;
        result.interrupted = !complete();
        for (size_t i = 0; i < m_runs.size(); ++i) {
            const bool askedFor = m_contestants.strategies[i].askedFor;
            const bool isLimit = this->isLimit(i);
            if (!askedFor && !isLimit) continue;
            RunMeasurement run = m_runs[i];
            run.summary = summaryOf(m_runs[i], m_runs, *m_request.scene);
            if (isLimit) result.limit = run;
            if (askedFor) result.runs.push_back(std::move(run));
        }
        return result;
    }

    [[nodiscard]] std::vector<Measuring> runs() const {
        std::vector<Measuring> runs;
        for (size_t i = 0; i < m_runs.size(); ++i) runs.push_back({&m_runs[i], m_contestants.strategies[i].askedFor, isLimit(i)});
        return runs;
    }
    [[nodiscard]] const MeasureRequest& request() const { return m_request; }
    [[nodiscard]] const GlInfo& gl() const { return m_gl; }

private:
    [[nodiscard]] bool isLimit(size_t i) const { return m_request.limitToo && m_runs[i].strategy == limitAtDefaults(); }

    /// The pose in progress.
    struct Pose {
        View view;
        std::vector<size_t> numbers;  ///< of the strategies that take part, in the order of the rounds
        ViewRounds rounds;
    };
    /// What a strategy has taken so far.
    struct Taking {
        double seconds = 0.0;  ///< of counted frames
        bool ended = false;    ///< takes no part any more
    };

    void beginPose() {
        const View view(m_request.path.camera(m_poses), m_request.size);
        // A window behind the first one has the view of a later pose, evenly spread over the path.
        std::vector<View> others;
        const size_t count = m_request.path.poses.size();
        for (size_t window = 1; m_request.differentViews && window < m_targets.size(); ++window)
            others.emplace_back(m_request.path.camera((m_poses + window * count / m_targets.size()) % count), m_request.size);
        std::vector<size_t> numbers;
        std::vector<ViewSubject> subjects;
        for (size_t i = 0; i < m_runs.size(); ++i) {
            if (m_taking[i].ended) continue;
            const Contestant& contestant = m_contestants.strategies[i];
            numbers.push_back(i);
            subjects.push_back({m_buffers, contestant.strategy, view, std::move(m_memories[i])});
            subjects.back().others = others;
            subjects.back().judged = m_request.accuracy && (contestant.askedFor || isLimit(i));
        }
        TimingProtocol protocol = m_request.timing;
        if (protocol.warmUpOnce && m_poses > 0) protocol.warmUp = 0;
        // With one repetition, too, none always follows the same one.
        const bool backwards = m_poses % 2 != 0;
        m_pose.emplace(Pose{view, std::move(numbers), ViewRounds(std::move(subjects), protocol, backwards)});
    }

    void measureNext(const std::stop_token& stop) {
        ViewRounds& rounds = m_pose->rounds;
        const bool timing = !rounds.timed();
        try {
            (void)rounds.step(
                m_renderer, m_references, [this](const Viewport&, size_t window) -> Framebuffer& { return *m_targets[window]; },
                stop);
        } catch (const Error& error) {
            if (!timing || !isRefusal(error, m_request)) throw;
            const size_t number = m_pose->numbers[rounds.next()];
            m_contestants.refused.push_back({m_contestants.strategies[number].request, error.message()});
            m_taking[number].ended = true;
            rounds.dropNext();
        }
    }

    void endPose() {
        for (size_t i = 0; i < m_pose->numbers.size(); ++i) {
            if (m_pose->rounds.dropped(i)) continue;
            const size_t number = m_pose->numbers[i];
            RunMeasurement& run = m_runs[number];
            const Promise promise = m_contestants.strategies[number].strategy->promiseAt(m_pose->view);
            if (promise == Promise::Approximate) run.promise = Promise::Approximate;
            run.frames.push_back(m_pose->rounds.measurement(i));
            run.frames.back().pose = m_poses;
            m_memories[number] = m_pose->rounds.takeMemories(i);
            std::vector<uint32_t> lost = m_pose->rounds.takeLost(i);
            if (m_poses > 0) run.frames.back().toggledPixels = differentNumbers(m_lost[number], lost);
            m_lost[number] = std::move(lost);
            for (const double milliseconds : run.frames.back().frameTimes) m_taking[number].seconds += milliseconds / 1000.0;
            m_taking[number].ended = m_taking[number].seconds > m_request.secondsOfAStrategy;
        }
        ++m_poses;
        m_pose.reset();
        m_references.clear();
    }

    MeasureRequest m_request;
    Contestants m_contestants;
    GlInfo m_gl;
    std::shared_ptr<const SceneBuffers> m_buffers;
    Renderer m_renderer;
    std::vector<std::unique_ptr<Framebuffer>> m_targets;    ///< by window
    std::vector<RunMeasurement> m_runs;                     ///< by strategy, the baselines that were not asked for among them
    std::vector<Taking> m_taking;                           ///< by strategy
    std::vector<std::vector<ViewStatePointer>> m_memories;  ///< by strategy and window; at the rounds while a pose is in progress
    std::vector<std::vector<uint32_t>> m_lost;              ///< by strategy: the pixels lost at the newest complete pose
    References m_references;                                ///< of the pose in progress
    size_t m_poses = 0;                                     ///< measured completely
    std::optional<Pose> m_pose;
};

Meter::Meter(const MeasureRequest& request, Contestants contestants, const GlInfo& gl,
             std::shared_ptr<const SceneBuffers> buffers)
    : m_experiment(std::make_unique<Experiment>(request, std::move(contestants), gl, std::move(buffers))) {}
Meter::~Meter() = default;

void Meter::step(const std::stop_token& stop) { m_experiment->step(stop); }
bool Meter::complete() const { return m_experiment->complete(); }
size_t Meter::poses() const { return m_experiment->poses(); }
MeasureResult Meter::resultSoFar() const { return m_experiment->resultSoFar(); }
std::vector<Meter::Measuring> Meter::runs() const { return m_experiment->runs(); }
const MeasureRequest& Meter::request() const { return m_experiment->request(); }
const GlInfo& Meter::gl() const { return m_experiment->gl(); }

void MeasuredScene::show(const ScenePointer& scene) {
    if (m_scene == scene) return;
    m_buffers.clear();
    m_kept.clear();
    m_scene = scene;
}

std::shared_ptr<const SceneBuffers> MeasuredScene::buffers(const ScenePointer& scene, Upload upload) {
    show(scene);
    std::shared_ptr<const SceneBuffers>& buffers = m_buffers[upload];
    if (!buffers) {
        buffers = std::make_shared<const SceneBuffers>(scene, upload);
        ++m_uploads;
    }
    return buffers;
}

Contestants MeasuredScene::contestants(const MeasureRequest& request, const GlInfo& gl, const Progress& progress) {
    show(request.scene);
    Contestants built = buildContestants(request, gl, m_structures, progress);
    for (const Contestant& contestant : built.strategies) m_kept.insert(contestant.strategy->structure());
    return built;
}

MeasureResult measure(const MeasureRequest& request, const Progress& progress, const PoseObserver& afterPose,
                      MeasuredScene* shared) {
    requireSomething(request);
    const GlInfo gl = requireOpenGl45();
    MeasuredScene own;
    MeasuredScene& measured = shared != nullptr ? *shared : own;
    const std::shared_ptr<const SceneBuffers> buffers = measured.buffers(request.scene, request.upload);
    Meter meter(request, measured.contestants(request, gl, progress.part(0.0, kBuilding)), gl, buffers);
    const Progress measuring = progress.part(kBuilding, 1.0);
    while (!meter.complete()) {
        const size_t pose = meter.poses();
        measuring.tell(double(pose) / double(request.path.poses.size()), CULLSCOPE_TR("measuring"));
        while (meter.poses() == pose) {
            if (measuring.stopRequested()) return meter.resultSoFar();
            try {
                meter.step(measuring.stop);
            } catch (const Error& error) {
                if (error.kind() != ErrorKind::Interrupted) throw;
            }
        }
        if (afterPose) afterPose(meter);
    }
    return meter.resultSoFar();
}

}  // namespace cullscope
