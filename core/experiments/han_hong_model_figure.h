#pragma once

#include "core/experiments/han_hong_figures.h"

namespace cullscope::han_hong {

/// Figure 2: the object with the axes of its coordinates and one point by R, θ and φ, and below it all of the object over φ and θ
/// with the same point. Throws as `figure` does.
[[nodiscard]] Figure modelFigure(const FigureRequest& request, const PageLook& look, const Progress& progress);

}  // namespace cullscope::han_hong
