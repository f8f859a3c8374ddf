#pragma once

#include "core/gpu/gpu_frame.h"
#include "core/visibility/built_strategy.h"

namespace cullscope {

/// One decided and drawn frame. Everywhere in the program, fps means 1000 / frameMilliseconds.
struct FrameResult {
    FrameLog log;
    double frameMilliseconds = 0.0;  ///< cull + draw, until the GPU has finished
};

/// Runs a strategy's frame into `target`, which has the view's size, and waits for the GPU. `state` is the view's memory.
FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, ViewState& state,
                        const View& view, Framebuffer& target, const DrawStyle& style = {});

}  // namespace cullscope
