#pragma once

#include "core/visibility/registry.h"

namespace cullscope::distance {

/// `draw-distance`: leaves out the objects whose bounding spheres lie wholly beyond a distance from the eye, as many
/// games do. The distance is a multiple of the radius of the scene's bounding sphere, so that one value suits scenes of
/// any size. Approximate: what is visible beyond the distance is lost.
[[nodiscard]] RegisteredStrategy drawDistance();

}  // namespace cullscope::distance
