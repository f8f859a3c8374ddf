#pragma once

#include "core/visibility/registry.h"

namespace cullscope::frustum {

/// `frustum`: culls objects whose bounding sphere or axis-aligned box lies outside one of the six planes; all are tested in
/// batches with as many lanes as the processor has (geometry/frustum_batch.h). Conservative: an object that intersects the
/// frustum is always drawn (margin: geometry/frustum.h, conservativeMargin).
/// `box=p-vertex` tests n·c + d + |n|·e (Assarsson & Möller 2000). `box=oriented` tests the mesh's own box as transformed by the
/// instance, instead of the axis-aligned one. `box=length` tests the length of the extent vector only, as in Orangelie 2023, to
/// show the cost: it is the box's circumscribed sphere instead of the box. The last two test one object at a time.
[[nodiscard]] RegisteredStrategy frustum();

}  // namespace cullscope::frustum
