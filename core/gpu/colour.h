#pragma once

#include <cstdint>

#include "core/geometry/types.h"

namespace cullscope {

/// 0xRRGGBB.
[[nodiscard]] Vec3f colourFromHexadecimal(uint32_t rgb);

/// The relative luminance Y in [0, 1] of an sRGB colour (IEC 61966-2-1).
[[nodiscard]] float relativeLuminance(const Vec3f& colour);

/// Whether black stands out against a colour at least as well as white does, by WCAG's contrast ratio: (Y + 0.05) / 0.05 against
/// 1.05 / (Y + 0.05).
[[nodiscard]] bool isLight(const Vec3f& background);

/// Black on light, white on dark.
[[nodiscard]] Vec3f contrastTo(const Vec3f& background);

}  // namespace cullscope
