#include "core/gpu/colour.h"

#include <algorithm>
#include <cmath>

namespace cullscope {

Vec3f colourFromHexadecimal(uint32_t rgb) { return Vec3f(float(rgb >> 16), float(rgb >> 8 & 255), float(rgb & 255)) / 255.0f; }

Vec3f colourFromRamp(std::span<const uint32_t> ramp, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * double(ramp.size() - 1);
    const size_t from = std::min(size_t(place), ramp.size() - 2);
    return glm::mix(colourFromHexadecimal(ramp[from]), colourFromHexadecimal(ramp[from + 1]), float(place - double(from)));
}

float relativeLuminance(const Vec3f& colour) {
    const auto linear = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
    return 0.2126f * linear(colour.x) + 0.7152f * linear(colour.y) + 0.0722f * linear(colour.z);
}

bool isLight(const Vec3f& background) {
    const float luminance = relativeLuminance(background) + 0.05f;
    return luminance * luminance >= 1.05f * 0.05f;
}

Vec3f contrastTo(const Vec3f& background) { return isLight(background) ? Vec3f(0.0f) : Vec3f(1.0f); }

}  // namespace cullscope
