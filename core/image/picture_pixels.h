#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"
#include "core/raster/rows.h"

namespace cullscope {

/// Conversions of RGBA pixels for picture files.

/// RGBA bytes blended with a background, as RGB bytes.
[[nodiscard]] std::vector<uint8_t> flattened(const std::vector<uint8_t>& rgba, const Vec3f& background);

/// Converts sRGB bytes with straight alpha to linear floats multiplied by alpha, and back. Both together return the same bytes
/// where alpha is 255; where it is 0 the colour is lost.
[[nodiscard]] std::vector<float> linearPremultiplied(const std::vector<uint8_t>& rgba);
[[nodiscard]] std::vector<uint8_t> straightFromLinear(const std::vector<float>& rgba);

}  // namespace cullscope
