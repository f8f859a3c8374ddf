#pragma once

#include "core/visibility/registry.h"

namespace cullscope::spherical {

/// `spherical-horizon`: with the exact slope instead of S. Conservative where every mesh is star-shaped around the centre of its
/// bounding sphere, else approximate. It does not use corner rays: where the frustum cuts a sphere, only the slopes decide.
[[nodiscard]] RegisteredStrategy sphericalHorizon();

}  // namespace cullscope::spherical
