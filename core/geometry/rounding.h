#pragma once

#include <cmath>
#include <limits>

namespace cullscope {

/// A number rounded down to float: one float below its nearest one, towards 0. For a number above 0 never larger than it.
[[nodiscard]] inline float floatBelow(double value) { return std::nextafter(float(value), 0.0f); }
/// A number rounded up to float: one float above its nearest one. Never smaller than the number.
[[nodiscard]] inline float floatAbove(double value) {
    return std::nextafter(float(value), std::numeric_limits<float>::infinity());
}

}  // namespace cullscope
