#pragma once

#include "core/visibility/spherical/cell_scene.h"

namespace cullscope::spherical {

/// Decides and draws a frame of `spherical-lossless`.
void drawLossless(FrameContext& frame, const CellScene& structure, const ParameterSet& parameters);

}  // namespace cullscope::spherical
