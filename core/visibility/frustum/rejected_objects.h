#pragma once

#include "core/visibility/bars.h"
#include "core/visibility/show.h"

namespace cullscope::frustum {

/// The counts of objects by the plane of the frustum that rejected them, or their group.
[[nodiscard]] Show rejectedObjectsShow();
/// `axes`: whether separating axes are tested too, which reject what no single plane does.
[[nodiscard]] Bars rejectedObjects(const FrameLog& log, const Scene& scene, bool axes);

}  // namespace cullscope::frustum
