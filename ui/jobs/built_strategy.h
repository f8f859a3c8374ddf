#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "core/image/view_picture.h"
#include "core/measure/render_frame.h"
#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// A strategy built for a scene, with the scene it needs. Views and measurements share it: `mutex` is held around `cull` and
/// nothing else, so that neither waits for what the other draws.
struct BuiltStrategy {
    std::string id;
    ScenePointer scene;
    StrategyPointer strategy;
    GlRequirement glRequirement = GlRequirement::None;  ///< anything else: it can be culled on a thread with a context alone
    std::mutex mutex;
};

using BuiltStrategyPointer = std::shared_ptr<BuiltStrategy>;

/// One cull of a strategy that several threads share. `renderer`: of the thread's current context; null: this thread has none,
/// and the strategy asks for none. Throws what Strategy::cull throws.
[[nodiscard]] Verdict cullShared(BuiltStrategy& built, const View& view, Trace* trace, Renderer* renderer);

/// A look without the boxes, bands and kernels that the strategy does not have at this view. Needs no context: what asks OpenGL
/// is not asked, and has boxes.
[[nodiscard]] ViewLook shownLook(BuiltStrategy& built, const View& view, ViewLook look);

/// core's renderFrame for a strategy that several threads share. Waiting for the others is not part of the time.
FrameResult renderShared(Renderer& renderer, const SceneBuffers& buffers, BuiltStrategy& built, const View& view,
                         Framebuffer& target, const DrawStyle& style = {});

}  // namespace cullscope::ui
