#pragma once

#include <vector>

#include "core/spatial/instance_octree.h"
#include "core/visibility/octree_walk.h"
#include "tests/benchmark/frustum_objects.h"

namespace cullscope::benchmark {

/// The objects as instances of one mesh, and an octree over them, walked as by `frustum-octree`.
class Hierarchy {
public:
    /// A box has its own bounds, a sphere itself and its box.
    explicit Hierarchy(const std::vector<Box3>& boxes);
    explicit Hierarchy(const std::vector<Sphere>& spheres);
    /// Walks the octree with separating axes and the last failed plane first; returns the number of kept objects.
    [[nodiscard]] size_t kept(const View& view);

private:
    explicit Hierarchy(ScenePointer scene);

    ScenePointer m_scene;
    InstanceOctree m_octree;
    LastFailedPlanes m_memory;
};

}  // namespace cullscope::benchmark
