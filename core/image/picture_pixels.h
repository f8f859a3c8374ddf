#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

/// Conversions of RGBA pixels for picture files.

/// The same rows in reverse order: files store them from the top, pictures here from the bottom.
template <typename Value>
[[nodiscard]] std::vector<Value> upsideDown(const std::vector<Value>& values, int height) {
    const size_t rows = static_cast<size_t>(height);
    const size_t stride = rows > 0 ? values.size() / rows : 0;
    std::vector<Value> flipped;
    flipped.reserve(values.size());
    for (size_t row = rows; row-- > 0;)
        flipped.insert(flipped.end(), values.begin() + static_cast<std::ptrdiff_t>(row * stride),
                       values.begin() + static_cast<std::ptrdiff_t>((row + 1) * stride));
    return flipped;
}

/// RGBA bytes blended with a background, as RGB bytes.
[[nodiscard]] std::vector<uint8_t> flattened(const std::vector<uint8_t>& rgba, const Vec3f& background);

/// Converts sRGB bytes with straight alpha to linear floats multiplied by alpha, and back. Both together return the same bytes
/// where alpha is 255; where it is 0 the colour is lost.
[[nodiscard]] std::vector<float> linearPremultiplied(const std::vector<uint8_t>& rgba);
[[nodiscard]] std::vector<uint8_t> straightFromLinear(const std::vector<float>& rgba);

}  // namespace cullscope
