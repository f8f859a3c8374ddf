#pragma once

#include <cstddef>
#include <cstdint>

namespace cullscope {

/// The state of a triangle in one frame, by the first cause that applied. In the order of the legend.
enum class TriangleState : uint8_t {
    Visible,
    InVain,
    OutsideFrustum,
    BackFacing,
    Hidden,
    TooSmall,
    WronglyCulled,
    Undecided  ///< only of the first entries of a frame: what becomes of it is decided later
};
inline constexpr size_t kTriangleStateCount = 8;

}  // namespace cullscope
