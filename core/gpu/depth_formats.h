#pragma once

#include <span>
#include <vector>

#include "core/gpu/renderer.h"

namespace cullscope {

/// The format of a depth buffer.
enum class DepthFormat {
    Float32,  ///< what every Framebuffer has
    Fixed24   ///< what many programs have; with it depths of far surfaces are equal (stability case 19)
};

/// Draws some instances of a scene one after the other, both sides, into a cleared picture with a depth buffer of that format.
/// The colour of each pixel: the number in `instances` of the one that is seen, from 1; 0 where there is none. At most 255.
[[nodiscard]] std::vector<uint8_t> drawnWithDepth(Renderer& renderer, const SceneBuffers& buffers, const View& view,
                                                  std::span<const uint32_t> instances, DepthFormat format);

}  // namespace cullscope
