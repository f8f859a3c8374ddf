#pragma once

#include "core/visibility/registry.h"

namespace cullscope::ordering {

/// A binary space partitioning tree of the scene's triangles (Fuchs, Kedem & Naylor 1980), drawn from the far to the near side of
/// every plane without depth test, or the other way round with it. Loses no pixel.
[[nodiscard]] RegisteredStrategy bsp();

}  // namespace cullscope::ordering
