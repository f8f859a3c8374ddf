#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::frustum {

/// `frustum`: objects whose bounding sphere or axis-aligned box lies outside one of the six planes are left out, all tested in
/// batches with as many lanes as the processor has (geometry/frustum_batch.h). Conservative: an object that reaches into the
/// frustum is always drawn (bound: geometry/frustum.h, conservativeMargin).
/// `box=p-vertex` tests n·c + d + |n|·e (Assarsson & Möller 2000); `box=oriented` the mesh's own box as the object's transform
/// puts it, in place of the axis-aligned one; `box=length` tests the length of the extent vector alone, as in Orangelie 2023, to
/// show what it wastes: the box's circumscribed sphere in place of the box. The last two test one object after the other.
[[nodiscard]] StrategyInfo frustumInfo();
[[nodiscard]] StrategyPointer makeFrustum(ParameterSet parameters);

}  // namespace cullscope::frustum
