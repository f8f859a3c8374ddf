#include "core/visibility/scene_clusters.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "core/base/message.h"

namespace cullscope {

SceneClusters::SceneClusters(const Scene& scene, uint32_t size, const Progress& progress) : meshes(scene.meshes().size()) {
    progress.tell(0.0, CULLSCOPE_TR("clusters of triangles"));
    const std::vector<bool> shown = scene.shownMeshes();
    // Only the calling thread may tell of progress.
    const Progress silent{{}, progress.stop};
    tbb::parallel_for(size_t{0}, meshes.size(), [&](size_t i) {
        if (shown[i] && !progress.stopRequested()) meshes[i] = std::make_shared<ClusterTree>(scene.meshes()[i], size, silent);
    });
    progress.check();
    auto all = std::make_shared<TriangleOrder>();
    for (const ClusterTreePointer& tree : meshes)
        all->meshes.push_back(tree ? TriangleOrder::OfMesh{tree->indices(), tree->triangleOrder()} : TriangleOrder::OfMesh{});
    all->owner = std::make_shared<std::vector<ClusterTreePointer>>(meshes);
    order = std::move(all);
}

uint64_t SceneClusters::bytes() const {
    uint64_t sum = 0;
    for (const ClusterTreePointer& tree : meshes) sum += tree ? tree->bytes() : 0;
    return sum;
}

std::vector<StructureReport::Figure> SceneClusters::figures() const {
    double clusters = 0, cones = 0, nodes = 0, deepest = 0;
    for (const ClusterTreePointer& tree : meshes) {
        if (!tree) continue;
        clusters += double(tree->clusterCount());
        cones += double(tree->coneCount());
        nodes += double(tree->nodes().size());
        deepest = std::max(deepest, double(tree->deepestLevel()));
    }
    return {{"clusters", clusters}, {"cones", cones}, {"nodes", nodes}, {"deepest level", deepest}};
}

ParameterDeclaration clusterSizeParameter() {
    const char* description = CULLSCOPE_TR("How many triangles a cluster has at most. An object of no more is one cluster.");
    return readWhenBuilding(bySize({kClusterSize,
                                    ParameterType::Integer,
                                    int64_t{ClusterTree::kSize},
                                    double(ClusterTree::kLeastSize),
                                    double(ClusterTree::kMostSize),
                                    "",
                                    description,
                                    {}},
                                   ClusterTree::kLeastSize));
}

}  // namespace cullscope
