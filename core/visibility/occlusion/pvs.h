#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `pvs`: from-region visibility. Space is divided into view cells, and for each cell it is worked out beforehand which objects
/// may be seen from anywhere in it; a frame draws those of the eye's cell that lie in the frustum. Sampled sets have what rays
/// found (approximate); conservative ones all but what is proven to be hidden; given ones came with the scene, such as the
/// potentially visible set of a level (approximate: whoever made it is judged). Outside all cells, and in views for which the
/// proofs do not hold, a frame draws what lies in the frustum.
[[nodiscard]] RegisteredStrategy pvs();

}  // namespace cullscope::occlusion
