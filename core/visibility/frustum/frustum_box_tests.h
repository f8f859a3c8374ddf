#pragma once

#include "core/visibility/registry.h"

namespace cullscope::frustum {

// View-frustum culling with boxes of objects that OpenGL tests. In both strategies an object's box grows by a pixel and a depth
// bound, so that OpenGL's rounding loses nothing visible. A box that touches the view's near rectangle is visible without a test:
// OpenGL hits faces, and a box that contains the whole frustum has no face in it; the same holds with the eye just outside the
// box (stability case 26).

/// `frustum-select`, Cho et al.: draws the boxes in OpenGL's selection mode with the whole window as the pick region; the hit
/// records name the objects in view. Conservative. Two-sided by default, as in the paper. Needs a compatibility profile.
/// `buffer`: initial size of the hit buffer in words; on overflow it is doubled, the boxes are drawn again, and the size is kept.
[[nodiscard]] RegisteredStrategy frustumSelect();

/// `frustum-query`, the same without selection mode: one occlusion query for each box, without depth test, depth clamped instead
/// of clipped. Because clamping also hits boxes before the near or beyond the far plane, these are culled before the queries.
/// Conservative on samples. Waits for the results in the same frame.
[[nodiscard]] RegisteredStrategy frustumQuery();

}  // namespace cullscope::frustum
