#pragma once

#include <cstddef>

#include "core/geometry/frustum.h"

namespace cullscope {

/// Why a triangle, object or group is not drawn.
enum class Cause { OutsideFrustum, BackFacing, Hidden, TooSmall };
inline constexpr size_t kCauseCount = 4;
/// English, marked for translation.
[[nodiscard]] const char* causeName(Cause cause);
/// "left plane", …: English, marked for translation.
[[nodiscard]] const char* planeName(FrustumPlane plane);

}  // namespace cullscope
