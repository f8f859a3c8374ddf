#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace cullscope {

/// The occupancy value (构件占屏值) of each instance of a scene, in scene units: the largest of its primitives' (Du et al. 2017,
/// Definition 2; mesh/primitive/occupancy.h), so that value / distance stands for k·tan θ (equation 4). The paper leaves meshes
/// open. Of a mesh that is not known to consist of primitives, and of polygons among them, it is half the largest extent of its
/// own box, turned and stretched with the instance: half the length of a pipe, half the edge of a plate; that is at most half the
/// largest distance between two of its points, and at least 1/√3 of it. 0 for an instance without triangles.
[[nodiscard]] std::vector<double> occupancyValues(const Scene& scene);

}  // namespace cullscope
