#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// Figure 6 of Cho et al., "A View-Frustum Culling Technique Using OpenGL for Large Polygon Models": 400 bunnies from 40
/// viewpoints, direct rendering beside view-frustum culling, with the numbers that the paper's text states; over a walk, and over
/// viewsFittedToFigure6.
[[nodiscard]] std::vector<Experiment> choFigure6();

/// 40 views of a field of objects, from a ring inside its edge, each turned so that the planes keep a wanted share of it: 2.5 %
/// in nine, as in the paper's best view, and such a share in the others that 79 % are culled on average.
[[nodiscard]] CameraPath viewsFittedToFigure6(const Scene& scene);

}  // namespace cullscope
