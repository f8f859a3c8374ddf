#pragma once

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/gpu/context.h"
#include "core/gpu/scene_buffers.h"
#include "core/measure/frame_measurement.h"
#include "core/scene/camera_path.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {

struct MeasureRequest {
    ScenePointer scene;
    std::vector<StrategyRequest> strategies;
    CameraPath path;
    Viewport size;
    int windows = 1;              ///< pictures of that size in each frame
    bool differentViews = false;  ///< of the windows: the pose's and others of the path; false: all show the pose
    Upload upload = Upload::Vbo;
    TimingProtocol timing;
    bool accuracy = true;
    bool leaveOutUnavailable = false;  ///< strategies that this OpenGL cannot run are left out; false: they fail with an error
    bool baselinesToo = false;         ///< baselines that are not among the strategies have runs, behind the others
    /// limitOfCulling() is measured, too: every run then has a share of what can be gained. With `baselinesToo` it has a run
    /// behind the others.
    bool limitToo = false;
    /// What a strategy throws over the scene, a view or a lack of OpenGL stands in the result (`refused`), its run ends, and the
    /// others go on; false: it ends the measurement.
    bool refusalsAreResults = false;
    double secondsOfAStrategy = std::numeric_limits<double>::infinity();  ///< of counted frames, after which its run ends
};

/// What a strategy lost over the poses of a path.
struct Losses {
    uint64_t coveredPixels = 0;  ///< of the reference
    uint64_t missedPixels = 0;
    uint64_t missedBeyondSnapping = 0;  ///< with `beyondSnapping`
    bool beyondSnapping = false;        ///< whether it is those pixels that are lost (JudgedFrame::missedBeyondSnapping)
    uint64_t largestHolePixels = 0;
    std::optional<size_t> worstPose;  ///< with the most missed pixels; none where nothing is missed
};

struct Summary {
    double fpsOverall = 0.0;  ///< poses / total time
    double fpsMean = 0.0, fpsMin = 0.0, fpsMax = 0.0;
    double frameMillisecondsMedian = 0.0, frameMillisecondsP95 = 0.0, frameMillisecondsP99 = 0.0;
    double cullShare = 0.0;                 ///< of the frame time
    double culledFraction = 0.0;            ///< 1 less the share of the scene's triangles submitted, mean over poses
    std::optional<double> missedPixelRate;  ///< missed / covered, over all poses
    RatioEstimate ratioToOwnRule;  ///< ratioOver the poses, to the baseline with the same facing rule: what "×" says everywhere
    /// shareOfHeadroom: of the time that any culling could save, by the run of limitOfCulling(); none without such a run.
    std::optional<RatioEstimate> headroomShare;
    RatioEstimate ratioToTriangles, ratioToFrontFaces;      ///< the same to the baselines, whatever sides they draw
    RatioEstimate speedupVsTriangles, speedupVsFrontFaces;  ///< meanOfRatios over the poses, which papers quote
    std::vector<std::optional<RatioEstimate>> field;        ///< by fieldFigures(); empty: not judged
    /// With 95 % confidence the share of views that lose something is below this; none where one lost something.
    std::optional<double> lossBelow;
};

/// The measurement of one strategy over a path.
struct RunMeasurement {
    StrategyRequest strategy;
    Promise promise = Promise::Approximate;  ///< the weakest over the poses measured
    Facing facing = Facing::TwoSided;
    Facing referenceFacing = Facing::TwoSided;
    StrategyRequest ownRule;  ///< the baseline of Summary::ratioToOwnRule
    StructureReport structure;
    std::vector<FrameMeasurement> frames;  ///< by pose; the last ones are missing where it refused one or took too long
    Summary summary;

    /// None where it was not measured.
    [[nodiscard]] std::optional<Losses> losses() const;
    /// A conservative or exact strategy that lost a pixel (beyond the raster's snapping, where the reference draws other faces).
    [[nodiscard]] bool promiseBroken() const;
};

/// What a strategy does not do.
struct Refusal {
    StrategyRequest strategy;
    Message why;
};

struct MeasureResult {
    MeasureRequest request;
    GlInfo gl;
    std::vector<RunMeasurement> runs;
    std::optional<RunMeasurement> limit;  ///< that of limitOfCulling(), where it was measured
    std::vector<Refusal> refused;         ///< with MeasureRequest::refusalsAreResults: those that could not be built have no run
    std::vector<Message> leftOut;         ///< why requested strategies have no run
    bool interrupted = false;             ///< stopped early: the runs contain the poses measured until then
};

/// A strategy of a measurement, built.
struct Contestant {
    StrategyRequest request;
    BuiltStrategyPointer strategy;
    bool askedFor = true;  ///< false: a baseline measured only for the ratios
};

/// The baselines that are not among `strategies`, built; of one role, or of all. The only place that adds baselines to a
/// measurement.
[[nodiscard]] std::vector<Contestant> baselinesBeside(const std::vector<StrategyRequest>& strategies, const ScenePointer& scene,
                                                      StructureStore& structures, std::optional<BaselineRole> role = {},
                                                      const Progress& progress = {});

/// What single views of a scene are timed beside: the baselines (baselineUnder) and the limit of culling. Each is built once for
/// a scene.
class ViewBaselines {
public:
    [[nodiscard]] const BuiltStrategyPointer& under(Facing rule, const ScenePointer& scene, StructureStore& structures);
    /// limitOfCulling() at its defaults.
    [[nodiscard]] const BuiltStrategyPointer& limit(const ScenePointer& scene, StructureStore& structures);
    /// Leaves what was built for another scene, so that it does not keep that scene alive.
    void leaveOthers(const ScenePointer& scene);

private:
    std::array<BuiltStrategyPointer, kFacingRules> m_built;
    BuiltStrategyPointer m_limit;
};

struct Contestants {
    std::vector<Contestant> strategies;
    std::vector<Message> leftOut;  ///< why requested strategies are not among them
    std::vector<Refusal> refused;  ///< likewise, with MeasureRequest::refusalsAreResults
};

/// Builds what a request asks for, and the baselines that it does not ask for, so that every run has its ratios. Needs no
/// context. Throws Error(Usage) for a request of nothing, Error(OpenGl) for a strategy that `gl` cannot run, what a strategy
/// throws, and Error(Interrupted) on a stop request.
[[nodiscard]] Contestants buildContestants(const MeasureRequest& request, const GlInfo& gl, StructureStore& structures,
                                           const Progress& progress = {});

/// A measurement in steps of one frame or one comparison with the truth: every strategy at every pose, in turns. The caller
/// may do other work between the steps. Needs the same current context, or one of its share group, in every call but resultSoFar.
class Meter {
public:
    Meter(const MeasureRequest& request, Contestants contestants, const GlInfo& gl, std::shared_ptr<const SceneBuffers> buffers);
    ~Meter();

    /// Throws Error(Interrupted) where a strategy ended its frame on the stop request.
    void step(const std::stop_token& stop = {});
    [[nodiscard]] bool complete() const;
    /// The poses measured completely so far: only those are in results, so that every ratio has both of its times.
    [[nodiscard]] size_t poses() const;
    /// Costs a copy and the bootstraps: call it only where the result is needed. `interrupted` while poses are missing.
    [[nodiscard]] MeasureResult resultSoFar() const;

    /// A strategy's run with the poses measured completely so far, without its summary.
    struct Measuring {
        const RunMeasurement* run;
        bool askedFor;  ///< false: measured only for the ratios
        bool isLimit;   ///< MeasureResult::limit
    };
    /// All runs, without a copy; valid until the next step.
    [[nodiscard]] std::vector<Measuring> runs() const;
    /// What is measured: with baselines and limit where they have runs.
    [[nodiscard]] const MeasureRequest& request() const;
    [[nodiscard]] const GlInfo& gl() const;

private:
    class Experiment;
    std::unique_ptr<Experiment> m_experiment;
};

/// What the measurements of one scene have in common, one after the other: its upload, and each structure that one of them built.
/// Another scene takes their place. Needs the same current context, or one of its share group, while it lives.
class MeasuredScene {
public:
    /// The scene's buffers, uploaded here if there are none yet.
    [[nodiscard]] std::shared_ptr<const SceneBuffers> buffers(const ScenePointer& scene, Upload upload);
    /// The strategies of a request, built here if no measurement built them (buildContestants).
    [[nodiscard]] Contestants contestants(const MeasureRequest& request, const GlInfo& gl, const Progress& progress);

    /// How many uploads were made and structures were built so far. For tests: neither is made twice.
    [[nodiscard]] size_t uploads() const { return m_uploads; }
    [[nodiscard]] size_t built() const { return m_structures.built(); }

private:
    void show(const ScenePointer& scene);

    ScenePointer m_scene;
    std::map<Upload, std::shared_ptr<const SceneBuffers>> m_buffers;
    StructureStore m_structures;
    std::set<StructurePointer> m_kept;
    size_t m_uploads = 0;
};

/// Called with the meter, whose poses so far are measured completely.
using PoseObserver = std::function<void(const Meter& meter)>;

/// Builds, uploads and runs a Meter to its end. Needs a current context. A stop request ends it at the next frame, and the poses
/// measured until then are returned; errors are thrown. `afterPose` is called on the measuring thread after every complete pose.
/// `shared`: of several measurements one after the other, each of which uploads and builds only what is new.
[[nodiscard]] MeasureResult measure(const MeasureRequest& request, const Progress& progress = {},
                                    const PoseObserver& afterPose = {}, MeasuredScene* shared = nullptr);

}  // namespace cullscope
