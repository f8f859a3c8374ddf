#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::frustum {

/// `frustum-octree`: an octree over the objects, from the root down (visibility/group_walk.h). A group outside a plane is left
/// out with all it holds, planes that have all of a group inside are not tested below it, and the plane that left a group out the
/// last time is tested first (Assarsson & Möller 2000). `refine`: groups and objects that no single plane leaves out, but several
/// cut, are tested by separating axes too, which removes the plane tests' false positives at the frustum's edges (stability cases
/// 1 and 2). Conservative; what is kept is drawn nearest first.
[[nodiscard]] StrategyInfo frustumOctreeInfo();
[[nodiscard]] StrategyPointer makeFrustumOctree(ParameterSet parameters);

}  // namespace cullscope::frustum
