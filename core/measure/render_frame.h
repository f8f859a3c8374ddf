#pragma once

#include <mutex>

#include "core/gpu/framebuffer.h"
#include "core/gpu/renderer.h"
#include "core/visibility/strategy.h"

namespace cullscope {

/// One culled and drawn frame. Everywhere in the program, fps means 1000 / frameMilliseconds.
struct FrameResult {
    Verdict verdict;
    double frameMilliseconds = 0.0;  ///< cull + draw, until the GPU has finished
};

/// Culls, draws into `target` and waits for the GPU. `culling`, where it holds a lock, is given back between culling and drawing.
FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, Strategy& strategy, const View& view,
                        Framebuffer& target, const DrawStyle& style = {}, std::unique_lock<std::mutex> culling = {});

}  // namespace cullscope
