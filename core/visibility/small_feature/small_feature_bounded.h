#pragma once

#include "core/visibility/registry.h"

namespace cullscope::small_feature {

/// `small-feature-bounded`: small-feature culling whose loss has a bound in pixels, counted for the view's field and size. A
/// component whose projection holds no pixel centre is left out and loses nothing. The small components of a group are left out
/// together, and only where all of them cover no more pixels than the parameter `pixels`, so that many small parts side by side
/// leave no hole. With `pixels=0` it is conservative. The frame says what it may have lost (figure `lost_pixels_at_most`).
[[nodiscard]] RegisteredStrategy smallFeatureBounded();

}  // namespace cullscope::small_feature
