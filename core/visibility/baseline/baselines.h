#pragma once

#include "core/visibility/strategy.h"

namespace cullscope::baseline {

/// `all`: every triangle, two-sided: the baseline of the papers.
[[nodiscard]] StrategyInfo allInfo();
[[nodiscard]] StrategyPointer makeAll(ParameterSet parameters);

/// `backface`: every triangle, OpenGL culls back faces. The stronger baseline. Measured against the two-sided reference:
/// conservative, up to the raster's snapping, on closed outward meshes seen from outside; approximate elsewhere.
[[nodiscard]] StrategyInfo backfaceInfo();
[[nodiscard]] StrategyPointer makeBackface(ParameterSet parameters);

}  // namespace cullscope::baseline
