#include "core/measure/reference.h"

#include <algorithm>

namespace cullscope {

Reference itemBufferReference(Renderer& renderer, const SceneBuffers& buffers, const View& view, Facing facing) {
    Renderer::ItemBuffer items = renderer.drawItemBuffer(buffers, view, everything(buffers.scene(), facing));
    Reference reference;
    reference.size = view.viewport();
    reference.facing = facing;
    reference.depth = std::move(items.depth);
    reference.triangle = std::move(items.triangle);
    for (const uint32_t item : reference.triangle)
        if (item != 0) reference.visibleTriangles.push_back(item - 1);
    reference.coveredPixels = reference.visibleTriangles.size();
    std::sort(reference.visibleTriangles.begin(), reference.visibleTriangles.end());
    reference.visibleTriangles.erase(std::unique(reference.visibleTriangles.begin(), reference.visibleTriangles.end()),
                                     reference.visibleTriangles.end());
    return reference;
}

std::shared_ptr<const Reference> References::of(Renderer& renderer, const SceneBuffers& buffers, const View& view,
                                                Facing facing) {
    for (const Known& known : m_known)
        if (known.scene == buffers.scenePointer() && known.camera == view.camera() && known.truth->size == view.viewport() &&
            known.truth->facing == facing)
            return known.truth;
    ++m_drawn;
    auto truth = std::make_shared<const Reference>(itemBufferReference(renderer, buffers, view, facing));
    m_known.push_back({buffers.scenePointer(), view.camera(), truth});
    return truth;
}

void References::keep(const std::function<bool(const ScenePointer&, const Camera&, const Viewport&)>& used) {
    std::erase_if(m_known, [&](const Known& known) { return !used(known.scene, known.camera, known.truth->size); });
}

}  // namespace cullscope
