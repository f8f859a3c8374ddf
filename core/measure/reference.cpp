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

}  // namespace cullscope
