#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

// Occlusion culling on the processor. Near objects' largest triangles are drawn into a picture in software, and what lies behind
// them is left out: groups of an octree with all their objects, and objects one by one (buffer_walk.h says in which order, and
// why nothing visible is lost). Both are conservative.

/// `occlusion-depth`: the picture has a depth for every pixel.
[[nodiscard]] RegisteredStrategy occlusionDepth();
/// `occlusion-masked`: it has two depths and a mask for each 8 × 4 pixels (Hasselgren, Andersson & Akenine-Möller 2016).
[[nodiscard]] RegisteredStrategy occlusionMasked();

}  // namespace cullscope::occlusion
