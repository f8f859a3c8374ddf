#pragma once

#include "core/experiments/han_hong_figures.h"

namespace cullscope::han_hong {

/// Figure 3: the corner rays with their entries and hits, as a whole and from nearby, from a camera that sees as many of the hits
/// as one beside the culling view can; and how one ray is searched: its R beside that of the triangles of each cell that it
/// passes. Throws as `figure` does.
[[nodiscard]] Figure searchFigure(const FigureRequest& request, const PageLook& look, const Progress& progress);

}  // namespace cullscope::han_hong
