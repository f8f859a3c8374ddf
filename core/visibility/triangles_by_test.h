#pragma once

#include "core/visibility/bars.h"
#include "core/visibility/show.h"

namespace cullscope {

/// The counts of triangles by the test that left them out, of strategies that walk trees over objects' triangles (part_walk.h).
/// `hiding`: what the bar of hidden triangles is called, English and marked for translation.
[[nodiscard]] Show trianglesByTestShow();
[[nodiscard]] Bars trianglesByTest(const FrameLog& log, const Scene& scene, const char* hiding);

}  // namespace cullscope
