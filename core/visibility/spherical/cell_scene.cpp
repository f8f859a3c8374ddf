#include "core/visibility/spherical/cell_scene.h"

#include <algorithm>

namespace cullscope::spherical {
namespace {

TriangleOrderPointer orderOfCells(const std::vector<MeshCells>& meshes) {
    auto order = std::make_shared<TriangleOrder>();
    auto owner = std::make_shared<std::vector<CellTreePointer>>();
    for (const MeshCells& mesh : meshes) {
        owner->push_back(mesh.tree);
        order->meshes.push_back(mesh.tree && mesh.tree->divided()
                                    ? TriangleOrder::OfMesh{mesh.tree->indices(), mesh.tree->triangleOrder()}
                                    : TriangleOrder::OfMesh{});
    }
    order->owner = std::move(owner);
    return order;
}

void reportCells(CellScene& structure) {
    double nodes = 0, leaves = 0, deepest = 0, treeBytes = 0, kernels = 0, kernelBytes = 0, cornerBytes = 0;
    for (const MeshCells& mesh : structure.meshes) {
        if (!mesh.tree) continue;
        nodes += double(mesh.tree->nodes().size());
        leaves += double(mesh.tree->leafCount());
        deepest = std::max(deepest, double(mesh.tree->deepestLevel()));
        treeBytes += double(mesh.tree->bytes());
        if (mesh.tree->mesh().triangleCount() > 0) structure.report.layout = mapLayoutId(mesh.tree->layout());
        cornerBytes += double(mesh.corners.bytes());
        if (!mesh.kernel) continue;
        kernels += mesh.kernel->filled() ? 1 : 0;
        kernelBytes += double(mesh.kernel->bytes());
    }
    structure.report.bytes = uint64_t(treeBytes + kernelBytes + cornerBytes) + structure.octree.bytes();
    structure.report.figures = {{"objects", double(structure.scene().instances().size())},
                                {"groups", double(structure.octree.nodes().size())},
                                {"cells", nodes},
                                {"leaf cells", leaves},
                                {"deepest level", deepest},
                                {"kernels", kernels},
                                {"cell tree bytes", treeBytes},
                                {"kernel bytes", kernelBytes},
                                {"corner bytes", cornerBytes},
                                {"octree bytes", double(structure.octree.bytes())}};
}

}  // namespace

void buildCells(CellScene& structure, const CellTree::Options& options, size_t leastTrianglesForKernel, bool corners,
                const Progress& progress) {
    const Scene& scene = structure.scene();
    structure.meshes.resize(scene.meshes().size());
    const std::vector<bool> shown = scene.shownMeshes();
    const auto count = double(structure.meshes.size());
    for (size_t i = 0; i < structure.meshes.size(); ++i) {
        if (!shown[i]) continue;
        const Progress part = progress.part(double(i) / count, double(i + 1) / count);
        const MeshPointer& mesh = scene.meshes()[i];
        structure.meshes[i].tree = std::make_shared<CellTree>(mesh, options, part);
        // Also where the horizon is switched off: switching it on builds nothing.
        if (mesh->triangleCount() >= leastTrianglesForKernel) structure.meshes[i].kernel = std::make_shared<InnerKernel>(*mesh);
        structure.meshes[i].maps = LazyMaps(mesh);
        const CellTree& tree = *structure.meshes[i].tree;
        structure.meshes[i].shareFacingAway = meanShareFacingAway(SurfaceNodes(tree.nodes()));
        if (corners && tree.divided()) structure.meshes[i].corners = CornerBlocks(*mesh, tree.indices());
    }
    structure.octree = InstanceOctree(scene, InstanceOctree::kLeafInstances, progress);
    structure.order = orderOfCells(structure.meshes);
    reportCells(structure);
}

MeshStates kernelStates(const CellScene& structure, bool used) {
    MeshStates states{"kernels", "inner kernel", {}};
    for (const MeshCells& mesh : structure.meshes)
        if (mesh.tree && mesh.tree->mesh().triangleCount() > 0)
            ++states.meshes[used && mesh.kernel ? InnerKernel::stateName(mesh.kernel->state()) : "not made"];
    return states;
}

}  // namespace cullscope::spherical
