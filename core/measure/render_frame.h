#pragma once

#include <span>

#include "core/gpu/gpu_frame.h"
#include "core/visibility/built_strategy.h"

namespace cullscope {

/// One decided and drawn frame. Everywhere in the program, fps means 1000 / frameMilliseconds.
struct FrameResult {
    FrameLog log;                    ///< of the first picture
    double frameMilliseconds = 0.0;  ///< cull + draw of all pictures, until the GPU has finished, without untimed parts
    double cullMilliseconds = 0.0;   ///< of all pictures
};

/// A picture of a frame: what it is drawn into, which has the view's size, and the memory of its view.
struct FrameTarget {
    Framebuffer* target = nullptr;
    ViewState* state = nullptr;
    const View* view = nullptr;  ///< of the same size; null: that of the frame
};

/// Runs a strategy's frame, culling and drawing for each picture, and waits for the GPU. There is at least one picture. Throws
/// Error(Interrupted) where a strategy ended its frame on the stop request.
FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const View& view,
                        std::span<const FrameTarget> pictures, const DrawStyle& style = {}, const std::stop_token& stop = {});

/// The same with one picture.
FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, ViewState& state,
                        const View& view, Framebuffer& target, const DrawStyle& style = {}, const std::stop_token& stop = {});

}  // namespace cullscope
