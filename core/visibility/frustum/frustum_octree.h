#pragma once

#include "core/visibility/registry.h"

namespace cullscope::frustum {

/// `frustum-octree`: an octree over the objects, walked from the root (visibility/octree_walk.h). A group outside a plane is
/// culled with all its objects; planes that a group lies completely inside are not tested below it; and the plane that last
/// culled a group is tested first (Assarsson & Möller 2000). `refine`: groups and objects that are outside no single plane but
/// cut by several are also tested by separating axes, which removes the false positives of plane tests at the frustum's edges
/// (stability cases 1 and 2). Conservative; the kept objects are drawn nearest first.
[[nodiscard]] RegisteredStrategy frustumOctree();

}  // namespace cullscope::frustum
