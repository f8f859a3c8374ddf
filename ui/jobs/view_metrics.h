#pragma once

#include "core/base/message.h"
#include "core/measure/view_rounds.h"
#include "ui/jobs/view_frames.h"

namespace cullscope::ui {

/// All inputs of the metrics: equal subjects have equal counts.
struct MetricsSubject {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport size;
    uint32_t turn = 0;  ///< FrameRequest::turn

    bool operator==(const MetricsSubject&) const = default;
};

/// Speed and error of one view's strategy at the present camera, as core measures them.
struct ViewMetrics : ViewFigures {
    enum class State {
        Nothing,    ///< no scene is open
        Stale,      ///< camera, size or strategy changed since; a measurement is running or about to start
        OnRequest,  ///< the scene is too large for automatic measurement: wait for the user's request
        Ready,
        Failed  ///< `failure` says why
    };
    State state = State::Nothing;
    Message failure;
    uint64_t timing = 0;  ///< number of the measurement that the times are of; `frameTimes` of one number are of the same turns

    MetricsSubject subject;  ///< the inputs of this measurement
    ViewFramePointer frame;  ///< of the view's picture and panels, which the timed frames repeat
};

}  // namespace cullscope::ui
