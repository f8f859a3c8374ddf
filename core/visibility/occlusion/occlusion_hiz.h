#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `occlusion-hiz`: draws what was visible in the frame before, reduces its depth to a pyramid, and has OpenGL test the other
/// objects against it and draw those that are not hidden in the same frame (two_passes.h). Conservative on samples.
[[nodiscard]] RegisteredStrategy occlusionHiz();

}  // namespace cullscope::occlusion
