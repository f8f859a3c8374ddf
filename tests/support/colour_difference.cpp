#include "tests/support/colour_difference.h"

#include <cmath>
#include <numbers>

namespace cullscope::test {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

double hueDegrees(double b, double a) {
    if (a == 0.0 && b == 0.0) return 0.0;
    const double hue = std::atan2(b, a) / kRadians;
    return hue < 0.0 ? hue + 360.0 : hue;
}

double hueDifference(double from, double to, bool grey) {
    if (grey) return 0.0;
    const double difference = to - from;
    if (difference > 180.0) return difference - 360.0;
    return difference < -180.0 ? difference + 360.0 : difference;
}

double meanHue(double first, double second, bool grey) {
    const double sum = first + second;
    if (grey) return sum;
    if (std::abs(first - second) <= 180.0) return sum / 2;
    return sum < 360.0 ? (sum + 360.0) / 2 : (sum - 360.0) / 2;
}

double chromaCurve(double chroma) {
    const double seventh = std::pow(chroma, 7);
    return std::sqrt(seventh / (seventh + std::pow(25.0, 7)));
}

/// A matrix from rows as printed in papers; GLM stores columns.
Mat3 fromRows(const Vec3& x, const Vec3& y, const Vec3& z) { return glm::transpose(Mat3(x, y, z)); }

}  // namespace

double ciede2000(const Lab& first, const Lab& second) {
    const double g = 0.5 * (1.0 - chromaCurve((std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2));
    const double a1 = first.a * (1.0 + g), a2 = second.a * (1.0 + g);
    const double c1 = std::hypot(a1, first.b), c2 = std::hypot(a2, second.b);
    const double h1 = hueDegrees(first.b, a1), h2 = hueDegrees(second.b, a2);
    const bool grey = c1 * c2 == 0.0;

    const double lightness = second.lightness - first.lightness;
    const double chroma = c2 - c1;
    const double hue = 2.0 * std::sqrt(c1 * c2) * std::sin(hueDifference(h1, h2, grey) / 2 * kRadians);

    const double l = (first.lightness + second.lightness) / 2;
    const double c = (c1 + c2) / 2;
    const double h = meanHue(h1, h2, grey);
    const double t = 1.0 - 0.17 * std::cos((h - 30) * kRadians) + 0.24 * std::cos(2 * h * kRadians) +
                     0.32 * std::cos((3 * h + 6) * kRadians) - 0.20 * std::cos((4 * h - 63) * kRadians);
    const double sl = 1.0 + 0.015 * (l - 50) * (l - 50) / std::sqrt(20 + (l - 50) * (l - 50));
    const double sc = 1.0 + 0.045 * c;
    const double sh = 1.0 + 0.015 * c * t;
    const double rotation = 30.0 * std::exp(-((h - 275) / 25) * ((h - 275) / 25));
    const double rt = -std::sin(2 * rotation * kRadians) * 2.0 * chromaCurve(c);
    return std::sqrt(std::pow(lightness / sl, 2) + std::pow(chroma / sc, 2) + std::pow(hue / sh, 2) +
                     rt * (chroma / sc) * (hue / sh));
}

Vec3 linearOf(const Vec3& srgb) {
    const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return {linear(srgb.x), linear(srgb.y), linear(srgb.z)};
}

Lab labOf(const Vec3& linear) {
    static const Mat3 kXyz =
        fromRows({0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041});
    const Vec3 relative = (kXyz * linear) / (kXyz * Vec3(1.0));
    const auto f = [](double x) { return x > 216.0 / 24389 ? std::cbrt(x) : (24389.0 / 27 * x + 16) / 116; };
    const Vec3 v(f(relative.x), f(relative.y), f(relative.z));
    return {116 * v.y - 16, 500 * (v.x - v.y), 200 * (v.y - v.z)};
}

Vec3 Sight::seen(const Vec3& linearColour) const { return glm::clamp(linear * linearColour, 0.0, 1.0); }

const std::array<Sight, 5>& sights() {
    const Vec3 luminance(0.2126729, 0.7151522, 0.0721750);
    static const std::array<Sight, 5> kSights{
        {{"normal sight", Mat3(1.0)},
         {"greyscale", fromRows(luminance, luminance, luminance)},
         {"protanopia",
          fromRows({0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998})},
         {"deuteranopia",
          fromRows({0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881})},
         {"tritanopia",
          fromRows({1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900})}}};
    return kSights;
}

}  // namespace cullscope::test
