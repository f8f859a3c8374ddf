#pragma once

#include "core/visibility/strategy.h"

namespace cullscope {

/// `frustum`: objects whose bounding sphere or axis-aligned box lies outside one of the six planes are left out.
/// Conservative: an object that reaches into the frustum is always drawn (bound: geometry/frustum.h, conservativeSlack).
/// `box=p-vertex` tests n·c + d + |n|·e (Assarsson & Möller 2000); `box=length` tests the length of the extent vector, as in
/// Orangelie 2023, to show what it wastes: the box's circumscribed sphere in place of the box.
[[nodiscard]] StrategyInfo frustumInfo();
[[nodiscard]] StrategyPointer makeFrustum(ParameterSet parameters);

}  // namespace cullscope
