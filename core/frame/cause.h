#pragma once

#include <cstddef>

#include "core/geometry/frustum.h"

namespace cullscope {

/// Why a triangle, object or group is not drawn.
enum class Cause {
    OutsideFrustum,
    BackFacing,
    Hidden,
    TooSmall,  ///< by a rule of the strategy
    NoSample   ///< no pixel centre lies in it
};
inline constexpr size_t kCauseCount = 5;
/// English, marked for translation.
[[nodiscard]] const char* causeName(Cause cause);
/// "left plane", …: English, marked for translation.
[[nodiscard]] const char* planeName(FrustumPlane plane);

}  // namespace cullscope
