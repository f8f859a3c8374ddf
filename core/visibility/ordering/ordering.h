#pragma once

#include "core/visibility/registry.h"

namespace cullscope::ordering {

/// The painter's algorithm: all triangles from far to near without depth test, by the tests of Newell, Newell & Sancha (1972), or
/// by their centroids alone (`sort=centroid`). The first loses no pixel.
[[nodiscard]] RegisteredStrategy painter();

/// A binary space partitioning tree of the scene's triangles (Fuchs, Kedem & Naylor 1980), drawn from the far to the near side of
/// every plane without depth test, or the other way round with it. Loses no pixel.
[[nodiscard]] RegisteredStrategy bsp();

}  // namespace cullscope::ordering
