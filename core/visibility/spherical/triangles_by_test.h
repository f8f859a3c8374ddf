#pragma once

#include "core/visibility/bars.h"
#include "core/visibility/show.h"

namespace cullscope::spherical {

/// The counts of triangles by the test of `spherical-lossless` that left them out.
[[nodiscard]] Show trianglesByTestShow();
[[nodiscard]] Bars trianglesByTest(const FrameLog& log, const Scene& scene);

}  // namespace cullscope::spherical
