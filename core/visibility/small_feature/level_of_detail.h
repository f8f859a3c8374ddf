#pragma once

#include "core/visibility/registry.h"

namespace cullscope::small_feature {

/// `level-of-detail`: an object that is far away is drawn with fewer triangles (spatial/detail_levels.h), by the measure of the
/// family: a length, here the error of a level, divided by the distance. No surface moves by more than `error` pixels in the
/// picture; `hysteresis` keeps a level from changing to and fro. Coarser levels are stand-ins (frame/draw_list.h), by which a
/// frame is compared with the truth object by object.
[[nodiscard]] RegisteredStrategy levelOfDetail();

}  // namespace cullscope::small_feature
