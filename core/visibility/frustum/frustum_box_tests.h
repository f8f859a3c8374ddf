#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::frustum {

// View-frustum culling that asks OpenGL which boxes of objects are in view. For both strategies the box of an object grows by a
// pixel and a depth bound, so that no rounding of OpenGL's loses what the object shows, and a box that reaches the view's near
// rectangle is visible without asking: OpenGL hits faces, and one that holds the whole frustum has none in it, nor has one with
// the eye just outside of it (stability case 26).

/// `frustum-select`: Cho et al.: the boxes drawn in OpenGL's selection mode with the whole window as the pick region; the
/// hit records name the objects in view. Conservative. Two-sided by default, as in the paper. Needs a compatibility profile.
/// `buffer`: words of the hit buffer to begin with; one that overflows is doubled and asked again, and kept as large.
[[nodiscard]] StrategyInfo frustumSelectInfo();
[[nodiscard]] StrategyPointer makeFrustumSelect(ParameterSet parameters);

/// `frustum-query`: its twin without that mode: an occlusion query a box, without depth test, depth clamped in place of clipped.
/// As clamped depth hits them too, boxes before near or beyond far are left out before they are asked about. Conservative on
/// samples. Waits for the answers of the same frame.
[[nodiscard]] StrategyInfo frustumQueryInfo();
[[nodiscard]] StrategyPointer makeFrustumQuery(ParameterSet parameters);

}  // namespace cullscope::frustum
