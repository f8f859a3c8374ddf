#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/frame/submitted.h"
#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/measure/statistics.h"
#include "core/visibility/triangle_states.h"
#include "ui/jobs/view_frames.h"

namespace cullscope::ui {

/// All inputs of the metrics: equal subjects have equal counts.
struct MetricsSubject {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport size;

    bool operator==(const MetricsSubject&) const = default;
};

/// An object of the scene with missed pixels.
struct LostObject {
    uint32_t instance = 0;
    uint64_t pixels = 0;
};

/// Speed and error of one view's strategy at the present camera, as far as they are known.
struct ViewMetrics {
    enum class State {
        Nothing,    ///< no scene is open
        Stale,      ///< camera, size or strategy changed since; a measurement is running or about to start
        OnRequest,  ///< the scene is too large for automatic measurement: wait for the user's request
        Ready,
        Failed  ///< `failure` says why
    };
    State state = State::Nothing;
    Message failure;

    double frameMilliseconds = 0.0;        ///< median, cull + draw
    double cullMilliseconds = 0.0;         ///< median
    std::optional<RatioEstimate> speedup;  ///< over `backface`: ratioOfTotals of this one view
    bool timed = false;                    ///< false: the errors are known, the speed is still being measured
    Submitted submitted;
    uint64_t consideredTriangles = 0;  ///< given to OpenGL, whole triangles and fragments alike
    uint64_t sceneTriangles = 0;
    Facing truthFacing = Facing::TwoSided;
    Viewport size;
    Accuracy accuracy;
    /// The number of missed pixels that the rasteriser's snapping of vertices does not explain. Only set where the snapping may
    /// explain some (measure/accuracy.h, JudgedFrame).
    std::optional<uint64_t> missedBeyondSnapping;

    /// The state of every triangle; set once the truth is known.
    std::shared_ptr<const TriangleStates> states;
    std::vector<Hole> holes;              ///< largest first
    std::vector<LostObject> lostObjects;  ///< most pixels first
    /// The promise at this camera, which may be weaker than the strategy's general promise.
    Promise promise = Promise::Approximate;
    MetricsSubject subject;  ///< the inputs of this measurement

    /// Missed pixels that count as a loss.
    [[nodiscard]] uint64_t lostPixels() const { return missedBeyondSnapping.value_or(accuracy.missedPixels); }
    [[nodiscard]] double submittedShare() const { return submitted.share(sceneTriangles); }
};

}  // namespace cullscope::ui
