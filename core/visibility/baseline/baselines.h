#pragma once

#include "core/visibility/registry.h"

namespace cullscope::baseline {

/// `all`: every triangle, two-sided: the baseline of the papers.
[[nodiscard]] RegisteredStrategy all();

/// `backface`: every triangle, OpenGL culls back faces. The stronger baseline. Measured against the two-sided reference:
/// conservative, up to the raster's snapping, on closed outward meshes without pockets that are inside out, seen from outside;
/// approximate elsewhere.
[[nodiscard]] RegisteredStrategy backface();

}  // namespace cullscope::baseline
