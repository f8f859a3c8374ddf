#pragma once

#include <cstddef>
#include <cstdint>

namespace cullscope {

/// The state of a triangle in one frame, by the first cause that applied. In the order of the legend.
enum class TriangleState : uint8_t { Visible, InVain, OutsideFrustum, BackFacing, Hidden, TooSmall, WronglyCulled };
inline constexpr size_t kTriangleStateCount = 7;

}  // namespace cullscope
