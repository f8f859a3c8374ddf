#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `pvs`: from-region visibility. Space is divided into view cells, and the objects that may be seen from anywhere in a cell are
/// computed when building. A frame draws those of the eye's cell that lie in the frustum. Sampled sets have the objects that rays
/// met (approximate). Conservative sets have all objects but those proven to be hidden. Given sets come from the scene's file,
/// such as a level's potentially visible sets (approximate: the level's compiler may have forgotten some). Where the eye lies in
/// no cell, and in views for which the proofs do not hold, a frame draws all objects in the frustum.
[[nodiscard]] RegisteredStrategy pvs();

}  // namespace cullscope::occlusion
