#include "ui/session/built_strategy.h"

#include <chrono>

#include "core/gpu/context.h"

namespace cullscope::ui {

Verdict cullShared(BuiltStrategy& built, const View& view, Trace* trace) {
    const std::lock_guard lock(built.mutex);
    return built.strategy->cull(view, trace);
}

bool testsBoxes(BuiltStrategy& built, const View& view) {
    const std::lock_guard lock(built.mutex);
    Trace trace;
    (void)built.strategy->cull(view, &trace);
    return !built.strategy->inside(trace).nodes.empty();
}

FrameResult renderShared(Renderer& renderer, const SceneBuffers& buffers, BuiltStrategy& built, const View& view,
                         Framebuffer& target, const DrawStyle& style) {
    std::unique_lock lock(built.mutex);
    const auto start = std::chrono::steady_clock::now();
    FrameResult result;
    result.verdict = built.strategy->cull(view);
    lock.unlock();
    renderer.draw(buffers, view, result.verdict.drawList, target, style);
    waitForGpu();
    result.frameMilliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    return result;
}

}  // namespace cullscope::ui
