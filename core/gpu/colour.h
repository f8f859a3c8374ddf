#pragma once

#include <cstdint>
#include <span>

#include "core/geometry/types.h"

namespace cullscope {

/// The colour 0xRRGGBB with components in [0, 1].
[[nodiscard]] Vec3f colourFromHexadecimal(uint32_t rgb);

/// The colour at a share, from 0 to 1, of the way through colours 0xRRGGBB at equal distances; two or more.
[[nodiscard]] Vec3f colourFromRamp(std::span<const uint32_t> ramp, double share);

/// The relative luminance Y in [0, 1] of an sRGB colour (IEC 61966-2-1).
[[nodiscard]] float relativeLuminance(const Vec3f& colour);

/// Whether black has at least as much contrast to a colour as white, by WCAG's contrast ratio: (Y + 0.05) / 0.05 against 1.05 /
/// (Y + 0.05).
[[nodiscard]] bool isLight(const Vec3f& background);

/// Black on a light background, white on a dark one.
[[nodiscard]] Vec3f contrastTo(const Vec3f& background);

}  // namespace cullscope
