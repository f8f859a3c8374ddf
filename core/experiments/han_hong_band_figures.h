#pragma once

#include "core/experiments/han_hong_figures.h"

namespace cullscope::han_hong {

/// Figures 5 to 8: what contour bands draw and hide of an object that is in view as a whole. All are of one frame, and all see
/// the object by one camera, so that they can be compared: across the sector whose S Figure 6 shows, a little from behind. Throws
/// as `figure` does.
[[nodiscard]] Figure bandFigure(const FigureRequest& request, const PageLook& look, const Progress& progress);

}  // namespace cullscope::han_hong
