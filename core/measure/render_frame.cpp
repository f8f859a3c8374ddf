#include "core/measure/render_frame.h"

#include <chrono>

namespace cullscope {

FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const View& view,
                        std::span<const FrameTarget> pictures, const DrawStyle& style, const std::stop_token& stop) {
    std::vector<std::unique_ptr<GpuFrame>> frames;
    const auto start = std::chrono::steady_clock::now();
    for (const FrameTarget& picture : pictures) {
        frames.push_back(std::make_unique<GpuFrame>(renderer, buffers, picture.view != nullptr ? *picture.view : view,
                                                    *picture.target, style));
        frames.back()->stopBy(stop);
        strategy.draw(*frames.back(), *picture.state);
    }
    waitForGpu();
    FrameResult result;
    result.frameMilliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    for (const auto& frame : frames) result.frameMilliseconds -= frame->untimedMilliseconds();
    for (const FrameTarget& picture : pictures) picture.state->frameMilliseconds = result.frameMilliseconds;
    for (const auto& frame : frames) {
        FrameLog log = frame->take();
        result.cullMilliseconds += log.cullMilliseconds;
        if (frame == frames.front()) result.log = std::move(log);
    }
    return result;
}

FrameResult renderFrame(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, ViewState& state,
                        const View& view, Framebuffer& target, const DrawStyle& style, const std::stop_token& stop) {
    const FrameTarget picture{&target, &state};
    return renderFrame(renderer, buffers, strategy, view, {&picture, 1}, style, stop);
}

}  // namespace cullscope
