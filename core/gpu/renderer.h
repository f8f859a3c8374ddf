#pragma once

#include <memory>

#include "core/gpu/framebuffer.h"
#include "core/gpu/scene_buffers.h"
#include "core/scene/camera.h"
#include "core/scene/draw_list.h"

namespace cullscope {

/// How a picture looks; never what is in it.
struct DrawStyle {
    Vec3f background{0.078f, 0.090f, 0.110f};
    float backgroundAlpha = 1.0f;
    Vec3f surface{0.80f, 0.80f, 0.78f};
};

/// Draws draw lists, nothing else: reversed-Z, eye-relative floats, one Lambert shader with a headlight at the eye.
/// One renderer a context; needs that context current in every call. After every call the state is what Qt expects:
/// OpenGL's defaults (glClipControl, depth and culling too), nothing bound, and the framebuffer that was bound before.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Clears `target` and draws the list as seen by `view` (whose viewport must be the target's size).
    void draw(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
              const DrawStyle& style = {});

    /// Ground truth: for every pixel the depth and the lowest triangle number (Scene numbering + 1; 0 = nothing) at that depth.
    /// Draws `list` in a depth pass with the same vertex program as `draw`, then with GL_EQUAL and an atomic minimum.
    struct ItemBuffer {
        std::vector<float> depth;
        std::vector<uint32_t> triangle;
    };
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list);

private:
    struct Programs;
    std::unique_ptr<Programs> m_programs;
};

/// Every triangle of a scene, instance by instance.
[[nodiscard]] DrawList everything(const Scene& scene, Facing facing);

/// Waits until the GPU has finished what was asked of it.
void waitForGpu();

}  // namespace cullscope
