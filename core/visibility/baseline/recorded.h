#pragma once

#include "core/visibility/registry.h"

namespace cullscope::baseline {

/// `recorded`: what another program says that it draws, from a file of drawn sets (scene/drawn_sets.h): at each view the set of
/// the pose whose camera is nearest. Without a file everything. Promises nothing: its losses are those of the other program.
[[nodiscard]] RegisteredStrategy recorded();

}  // namespace cullscope::baseline
