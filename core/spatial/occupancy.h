#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// The occupancy value (占屏值) of each instance of a scene, in scene units: the length by which its projection is measured, so
/// that value / distance stands for k·tan θ (Du et al. 2017, Definitions 1 and 2, equation 4). The paper defines it for
/// primitives and leaves meshes open. Of a mesh it is half the largest extent of its own box, turned and stretched with the
/// instance: half the length of a pipe, half the edge of a plate. It is at most half the largest distance between two of its
/// points, and at least 1/√3 of that. 0 for an instance without triangles.
[[nodiscard]] std::vector<double> occupancyValues(const Scene& scene);

}  // namespace cullscope
