#include "core/gpu/colour.h"

#include <cmath>

namespace cullscope {

Vec3f colourFromHexadecimal(uint32_t rgb) { return Vec3f(float(rgb >> 16), float(rgb >> 8 & 255), float(rgb & 255)) / 255.0f; }

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
