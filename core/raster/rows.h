#pragma once

#include <cstddef>
#include <vector>

namespace cullscope {

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

}  // namespace cullscope
