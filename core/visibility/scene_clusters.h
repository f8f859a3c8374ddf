#pragma once

#include <vector>

#include "core/spatial/cluster_tree.h"
#include "core/visibility/strategy.h"

namespace cullscope {

/// The clusters of a scene's meshes, and the order in which they are drawn.
struct SceneClusters {
    std::vector<ClusterTreePointer> meshes;  ///< by Scene::meshes(); null: without triangles or without an instance
    TriangleOrderPointer order;

    SceneClusters() = default;
    /// Of clusters of at most `size` triangles. Meshes are cut in parallel. Throws Error(Interrupted) on a stop request.
    SceneClusters(const Scene& scene, uint32_t size, const Progress& progress);

    [[nodiscard]] const ClusterTree& of(const Scene& scene, uint32_t instance) const {
        return *meshes[scene.instances()[instance].mesh];
    }
    [[nodiscard]] uint64_t bytes() const;
    /// "clusters", those with cones, "nodes" and "deepest level", of the meshes.
    [[nodiscard]] std::vector<StructureReport::Figure> figures() const;
};

/// The parameter "size": how many triangles a cluster has at most; read when building.
inline constexpr const char* kClusterSize = "size";
[[nodiscard]] ParameterDeclaration clusterSizeParameter();

}  // namespace cullscope
