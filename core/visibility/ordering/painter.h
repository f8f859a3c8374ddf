#pragma once

#include "core/visibility/registry.h"

namespace cullscope::ordering {

/// The painter's algorithm: all triangles from far to near without depth test, by the tests of Newell, Newell & Sancha (1972), or
/// by their centroids alone (`sort=centroid`). The first loses no pixel.
[[nodiscard]] RegisteredStrategy painter();

}  // namespace cullscope::ordering
