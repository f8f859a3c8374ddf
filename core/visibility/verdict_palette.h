#pragma once

#include <array>

#include "core/gpu/renderer.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// The verdicts' colours by TriangleState, for light and dark backgrounds (chosen by the background's luminance).
[[nodiscard]] std::array<PaletteEntry, kTriangleStateCount> verdictPalette(const Vec3f& background);

}  // namespace cullscope
