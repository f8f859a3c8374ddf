#include "core/measure/render_frame.h"

#include <chrono>

namespace cullscope {

FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, ViewState& state,
                        const View& view, Framebuffer& target, const DrawStyle& style) {
    const auto start = std::chrono::steady_clock::now();
    GpuFrame frame(renderer, buffers, view, target, style);
    strategy.draw(frame, state);
    waitForGpu();
    FrameResult result;
    result.frameMilliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    result.log = frame.take();
    return result;
}

}  // namespace cullscope
