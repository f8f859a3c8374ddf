#include "core/gpu/depth_formats.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace cullscope {

std::vector<uint8_t> drawnWithDepth(Renderer& renderer, const SceneBuffers& buffers, const View& view,
                                    std::span<const uint32_t> instances, DepthFormat format) {
    const Viewport size = view.viewport();
    Framebuffer target(size);
    unsigned depth = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &depth);
    glTextureStorage2D(depth, 1, format == DepthFormat::Fixed24 ? GL_DEPTH_COMPONENT24 : GL_DEPTH_COMPONENT32F, size.width,
                       size.height);
    glNamedFramebufferTexture(target.id(), GL_DEPTH_ATTACHMENT, depth, 0);
    // The number is found by what each instance changes: no colour has to be unshaded.
    std::vector<uint8_t> seen(size_t(size.width) * size_t(size.height), 0);
    DrawStyle style;
    renderer.clear(view, target, style);
    std::vector<uint8_t> before = target.readColour();
    for (size_t i = 0; i < instances.size(); ++i) {
        style.surface = i % 2 == 0 ? Vec3f(1, 0, 0) : Vec3f(0, 1, 0);
        const auto indices = uint32_t(buffers.scene().meshOf(instances[i]).indices().size());
        renderer.execute(buffers, view, DrawList{Facing::TwoSided, {{instances[i], 0, indices}}}, target, style, false);
        std::vector<uint8_t> after = target.readColour();
        for (size_t pixel = 0; pixel < seen.size(); ++pixel)
            if (!std::equal(after.begin() + ptrdiff_t(4 * pixel), after.begin() + ptrdiff_t(4 * pixel + 4),
                            before.begin() + ptrdiff_t(4 * pixel)))
                seen[pixel] = uint8_t(i + 1);
        before = std::move(after);
    }
    glDeleteTextures(1, &depth);
    return seen;
}

}  // namespace cullscope
