#pragma once

#include <cmath>
#include <limits>

namespace cullscope {

/// The float next to a number's nearest one, towards 0: for a number above 0 never larger than it.
[[nodiscard]] inline float floatBelow(double value) { return std::nextafter(float(value), 0.0f); }
/// The same away from minus infinity: never smaller than the number.
[[nodiscard]] inline float floatAbove(double value) { return std::nextafter(float(value), std::numeric_limits<float>::infinity()); }

}  // namespace cullscope
