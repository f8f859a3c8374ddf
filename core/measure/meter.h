#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/gpu/context.h"
#include "core/gpu/scene_buffers.h"
#include "core/measure/accuracy.h"
#include "core/scene/camera_path.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {

/// The number of repetitions of a frame (docs/measuring.md, "Speed").
struct TimingProtocol {
    int warmUp = 1;            ///< frames of each strategy and pose that are not counted
    int fixedRepetitions = 0;  ///< 0: until the median is steady
    int leastRepetitions = 3;
    int mostRepetitions = 21;
    double steadyWithin = 0.02;            ///< relative change of every strategy's median over the last two rounds
    double longFrameMilliseconds = 250.0;  ///< a strategy with longer frames counts as steady after leastRepetitions
};

struct MeasureRequest {
    ScenePointer scene;
    std::vector<StrategyRequest> strategies;
    CameraPath path;
    Viewport size;
    int windows = 1;  ///< pictures of that size in each frame
    Upload upload = Upload::Vbo;
    TimingProtocol timing;
    bool accuracy = true;
    bool leaveOutUnavailable = false;  ///< strategies that this OpenGL cannot run are left out; false: they fail with an error
};

/// The measurement of one strategy at one pose.
struct FrameMeasurement {
    size_t pose = 0;
    double frameMilliseconds = 0.0;  ///< median; cull + draw of all windows
    double cullMilliseconds = 0.0;   ///< median
    std::vector<Stage> stages;       ///< of one cull
    int repetitions = 0;
    uint64_t consideredTriangles = 0;                     ///< of one window
    std::array<uint64_t, kCauseCount> culledTriangles{};  ///< of one window, by Cause (FrameCounters)
    std::vector<CullPart> parts;                          ///< of one window (FrameCounters)
    std::vector<NamedFigure> figures;                     ///< of one window (FrameCounters)
    std::optional<Accuracy> accuracy;
    bool ownRaster = false;             ///< the frame shows other surfaces than the scene's, or in an order of its own
    uint64_t missedBeyondSnapping = 0;  ///< with `ownRaster`, or where the reference has another facing rule than the strategy
};

/// What a strategy lost over the poses of a path.
struct Losses {
    uint64_t coveredPixels = 0;  ///< of the reference
    uint64_t missedPixels = 0;
    uint64_t missedBeyondSnapping = 0;  ///< where the reference has another facing rule than the strategy
    uint64_t largestHolePixels = 0;
    std::optional<size_t> worstPose;  ///< with the most missed pixels; none where nothing is missed
};

struct Summary {
    double fpsOverall = 0.0;  ///< poses / total time
    double fpsMean = 0.0, fpsMin = 0.0, fpsMax = 0.0;
    double frameMillisecondsMedian = 0.0, frameMillisecondsP95 = 0.0, frameMillisecondsP99 = 0.0;
    double cullShare = 0.0;                    ///< of the frame time
    double culledFraction = 0.0;               ///< of the scene's triangles, mean over poses
    std::optional<double> missedPixelRate;     ///< missed / covered, over all poses
    double speedupVsAll = 0.0;                 ///< mean over poses of the ratio of frame times
    std::array<double, 2> speedupVsAllCi95{};  ///< bootstrap over poses
    double speedupVsBackface = 0.0;
    std::array<double, 2> speedupVsBackfaceCi95{};
};

/// The measurement of one strategy over a path.
struct RunMeasurement {
    StrategyRequest strategy;
    Promise promise = Promise::Approximate;  ///< the weakest over the poses measured
    Facing facing = Facing::TwoSided;
    Facing referenceFacing = Facing::TwoSided;
    StructureReport structure;
    std::vector<FrameMeasurement> frames;
    Summary summary;

    /// None where it was not measured.
    [[nodiscard]] std::optional<Losses> losses() const;
    /// A conservative or exact strategy that lost a pixel (beyond the raster's snapping, where the reference draws other faces).
    [[nodiscard]] bool promiseBroken() const;
};

struct MeasureResult {
    MeasureRequest request;
    GlInfo gl;
    std::vector<RunMeasurement> runs;
    std::vector<Message> leftOut;  ///< why requested strategies have no run
    bool interrupted = false;      ///< stopped early: the runs contain the poses measured until then
};

/// Called with a function that makes a result of the poses measured so far. That function costs a copy and the bootstrap: call it
/// only where the result is needed, and only before the observer returns.
using PoseObserver = std::function<void(const std::function<MeasureResult()>& resultSoFar)>;

/// Measures every strategy at every pose, interleaved, together with the baselines `all` and `backface` (measured also where they
/// are not requested, so that every run has its ratios). Needs a current context. A stop request ends it at the next frame, and
/// the poses measured until then are returned; errors are thrown. `afterPose` is called on the measuring thread after every
/// complete pose.
[[nodiscard]] MeasureResult measure(const MeasureRequest& request, const Progress& progress = {},
                                    const PoseObserver& afterPose = {});

}  // namespace cullscope
