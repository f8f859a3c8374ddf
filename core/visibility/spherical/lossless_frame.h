#pragma once

#include <algorithm>
#include <array>

#include "core/visibility/spherical/cell_scene.h"

namespace cullscope::spherical {

using CulledByCause = std::array<uint64_t, kCauseCount>;

/// The cause for which most of the culled triangles were culled.
[[nodiscard]] inline Cause mainCause(const CulledByCause& culled) {
    return static_cast<Cause>(std::max_element(culled.begin(), culled.end()) - culled.begin());
}

/// Decides and draws a frame of `spherical-lossless`.
void drawLossless(FrameContext& frame, const CellScene& structure, const ParameterSet& parameters);

}  // namespace cullscope::spherical
