#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/measure/accuracy.h"
#include "core/measure/reference.h"
#include "core/visibility/strategy.h"
#include "core/visibility/triangle_states.h"
#include "ui/jobs/built_strategy.h"
#include "ui/jobs/gpu_thread.h"

namespace cullscope::ui {

/// What figures depend on: equal subjects have equal counts.
struct MetricsSubject {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport size;

    bool operator==(const MetricsSubject&) const = default;
};

/// An object of the scene that lost pixels.
struct LostObject {
    uint32_t instance = 0;
    uint64_t pixels = 0;
};

/// What is known of one view's speed and error at the present camera.
struct ViewMetrics {
    enum class State {
        Nothing,    ///< there is no scene
        Stale,      ///< the camera, the size or the strategy changed since; being measured or about to be
        OnRequest,  ///< the scene is so large that truth is measured only when asked for
        Ready,
        Failed  ///< `failure` says why
    };
    State state = State::Nothing;
    Message failure;

    double frameMilliseconds = 0.0;  ///< median, cull + draw
    double cullMilliseconds = 0.0;   ///< median
    std::optional<double> speedup;   ///< median ratio of `backface`'s frame time to this one's
    bool timed = false;              ///< false: errors are known, the speed is still being measured
    uint64_t consideredTriangles = 0;
    uint64_t sceneTriangles = 0;
    Facing facing = Facing::TwoSided;
    Viewport size;
    Accuracy accuracy;
    /// How many of the missed pixels the raster's snapping does not explain; only where the strategy draws by another facing
    /// rule than the truth (`backface`).
    std::optional<uint64_t> missedBeyondSnapping;

    /// What became of every triangle; set once the truth is known.
    std::shared_ptr<const TriangleStates> states;
    std::vector<Hole> holes;              ///< largest first
    std::vector<LostObject> lostObjects;  ///< most pixels first
    /// The promise at this camera; may be less than the strategy's in general.
    Promise promise = Promise::Approximate;
    MetricsSubject subject;  ///< what was measured

    /// Missed pixels that break a promise.
    [[nodiscard]] uint64_t lostPixels() const { return missedBeyondSnapping.value_or(accuracy.missedPixels); }
    [[nodiscard]] double submittedShare() const {
        return sceneTriangles == 0 ? 0.0 : double(consideredTriangles) / double(sceneTriangles);
    }
};

/// The middle value; of an even count the mean of the two middle ones. Not of nothing.
[[nodiscard]] double median(std::vector<double> values);

}  // namespace cullscope::ui
