#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "core/image/view_picture.h"
#include "core/measure/render_frame.h"
#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// A strategy built for a scene, with that scene. Views and measurements share it. Callers hold `mutex` during `cull` only, so
/// that no thread waits while another one draws.
struct BuiltStrategy {
    std::string id;
    ScenePointer scene;
    StrategyPointer strategy;
    GlRequirement glRequirement = GlRequirement::None;  ///< None: `cull` runs on any thread; else on one with a context
    std::mutex mutex;
};

using BuiltStrategyPointer = std::shared_ptr<BuiltStrategy>;

/// Culls once with a strategy that several threads share. `renderer` belongs to the calling thread's current context; null: the
/// thread has no context, and the strategy must not require one. Throws what Strategy::cull throws.
[[nodiscard]] Verdict cullShared(BuiltStrategy& built, const View& view, Trace* trace, Renderer* renderer);

/// Returns `look` without the boxes, bands and kernels that the strategy does not provide at this view. Needs no context: a
/// strategy that requires OpenGL is not culled here; it keeps its boxes, and loses bands and kernel.
[[nodiscard]] ViewLook shownLook(BuiltStrategy& built, const View& view, ViewLook look);

/// Does the same as core's renderFrame for a strategy that several threads share. The time excludes the wait for the mutex.
FrameResult renderShared(Renderer& renderer, const SceneBuffers& buffers, BuiltStrategy& built, const View& view,
                         Framebuffer& target, const DrawStyle& style = {});

}  // namespace cullscope::ui
