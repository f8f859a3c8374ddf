#include "core/image/picture_pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cullscope {
namespace {

/// The sRGB transfer functions of IEC 61966-2-1.
float linearFromSrgb(float coded) { return coded <= 0.04045F ? coded / 12.92F : std::pow((coded + 0.055F) / 1.055F, 2.4F); }
float srgbFromLinear(float linear) {
    return linear <= 0.0031308F ? linear * 12.92F : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// NaN, which damaged files may hold, becomes 0.
uint8_t byteOf(float share) {
    return share > 0.0F ? static_cast<uint8_t>(std::lround(std::min(share, 1.0F) * 255.0F)) : uint8_t{0};
}

}  // namespace

std::vector<uint8_t> flattened(const std::vector<uint8_t>& rgba, const Vec3f& background) {
    std::vector<uint8_t> rgb;
    rgb.reserve(rgba.size() / 4 * 3);
    for (size_t pixel = 0; pixel < rgba.size(); pixel += 4) {
        const float alpha = static_cast<float>(rgba[pixel + 3]) / 255.0F;
        for (size_t c = 0; c < 3; ++c) {
            const float colour = static_cast<float>(rgba[pixel + c]) / 255.0F;
            rgb.push_back(byteOf(colour * alpha + background[static_cast<int>(c)] * (1.0F - alpha)));
        }
    }
    return rgb;
}

std::vector<float> linearPremultiplied(const std::vector<uint8_t>& rgba) {
    std::array<float, 256> linear{};
    for (size_t byte = 0; byte < linear.size(); ++byte) linear[byte] = linearFromSrgb(static_cast<float>(byte) / 255.0F);
    std::vector<float> result(rgba.size());
    for (size_t pixel = 0; pixel < rgba.size(); pixel += 4) {
        const float alpha = static_cast<float>(rgba[pixel + 3]) / 255.0F;
        for (size_t c = 0; c < 3; ++c) result[pixel + c] = linear[rgba[pixel + c]] * alpha;
        result[pixel + 3] = alpha;
    }
    return result;
}

std::vector<uint8_t> straightFromLinear(const std::vector<float>& rgba) {
    std::vector<uint8_t> result(rgba.size());
    for (size_t pixel = 0; pixel < rgba.size(); pixel += 4) {
        const float alpha = rgba[pixel + 3];
        for (size_t c = 0; c < 3; ++c)
            result[pixel + c] = byteOf(srgbFromLinear(std::max(0.0F, alpha > 0.0F ? rgba[pixel + c] / alpha : rgba[pixel + c])));
        result[pixel + 3] = byteOf(alpha);
    }
    return result;
}

}  // namespace cullscope
