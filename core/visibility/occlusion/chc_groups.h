#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/scene.h"
#include "core/spatial/instance_octree.h"

namespace cullscope::occlusion {

/// Which nodes OpenGL is asked about by one query (Mattausch, Bittner & Wimmer 2008, section 4.1). `staysHidden`: by node, the
/// probability that it is still hidden, in descending order. Consecutive nodes make a group: as many as give the largest |M| / C
/// before it falls, at most `most`. C is the expected number of queries: 1 for one node M; for several 1 + (1 - p) |M|, where p
/// is the product of their probabilities, because each is asked about by itself where one shows. Returns behind which node each
/// group ends, ascending.
[[nodiscard]] std::vector<size_t> questionEnds(std::span<const double> staysHidden, size_t most);

/// The boxes by which OpenGL is asked about a node (section 5): those of what it holds `depth` levels below it, or fewer, so that
/// their surfaces are together at most `area` times that of the node's own box. The level below a leaf is that of its objects.
/// Everything in the node lies in one of the boxes. They are at most 512, in world coordinates.
[[nodiscard]] std::vector<Box3> tightBoxes(const InstanceOctree& octree, const Scene& scene, uint32_t node, size_t depth,
                                           double area);

}  // namespace cullscope::occlusion
