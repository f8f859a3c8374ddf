#include "ui/jobs/built_strategy.h"

#include <algorithm>

#include "core/image/overlays.h"

namespace cullscope::ui {

Verdict cullShared(BuiltStrategy& built, const View& view, Trace* trace, Renderer* renderer) {
    const std::lock_guard lock(built.mutex);
    return built.strategy->cull(view, trace, renderer);
}

ViewLook shownLook(BuiltStrategy& built, const View& view, ViewLook look) {
    if (!look.boxes && !look.bands && !look.kernel) return look;
    if (built.glRequirement != GlRequirement::None) {
        look.bands = look.kernel = false;
        return look;
    }
    const std::lock_guard lock(built.mutex);
    Trace trace;
    (void)built.strategy->cull(view, &trace);
    const StructureSnapshot snapshot = built.strategy->snapshot(trace);
    look.boxes = look.boxes && !(snapshot.nodes.empty() && snapshot.maps.empty());
    look.bands = look.bands && std::ranges::any_of(snapshot.maps, [](const spherical::MapSnapshot& map) {
                     return map.decision.bands.has_value();
                 });
    look.kernel = look.kernel && std::ranges::any_of(snapshot.maps, hasKernel);
    return look;
}

FrameResult renderShared(Renderer& renderer, const SceneBuffers& buffers, BuiltStrategy& built, const View& view,
                         Framebuffer& target, const DrawStyle& style) {
    return renderFrame(renderer, buffers, *built.strategy, view, target, style, std::unique_lock(built.mutex));
}

}  // namespace cullscope::ui
