#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "core/measure/frame.h"
#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// A strategy built for a scene, with the scene it needs. Views and measurements share it: `mutex` is held around `cull` and
/// nothing else, so that neither waits for what the other draws.
struct BuiltStrategy {
    std::string id;
    ScenePointer scene;
    StrategyPointer strategy;
    std::mutex mutex;
};

using BuiltStrategyPointer = std::shared_ptr<BuiltStrategy>;

/// One cull of a strategy that several threads share.
[[nodiscard]] Verdict cullShared(BuiltStrategy& built, const View& view, Trace* trace);

/// Whether the strategy tests boxes at this view, which it then shows.
[[nodiscard]] bool testsBoxes(BuiltStrategy& built, const View& view);

/// core's renderFrame for a strategy that several threads share. Waiting for the others is not part of the time.
FrameResult renderShared(Renderer& renderer, const SceneBuffers& buffers, BuiltStrategy& built, const View& view,
                         Framebuffer& target, const DrawStyle& style = {});

}  // namespace cullscope::ui
