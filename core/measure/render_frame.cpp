#include "core/measure/render_frame.h"

#include <chrono>

namespace cullscope {

FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, Strategy& strategy, const View& view,
                        Framebuffer& target, const DrawStyle& style, std::unique_lock<std::mutex> culling) {
    const auto start = std::chrono::steady_clock::now();
    FrameResult result;
    result.verdict = strategy.cull(view, nullptr, &renderer);
    if (culling) culling.unlock();
    renderer.draw(buffers, view, result.verdict.drawList, target, style);
    waitForGpu();
    result.frameMilliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace cullscope
