#pragma once

#include "core/spatial/cell_tree.h"
#include "core/spatial/inner_kernel.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/sampled_triangles.h"
#include "core/visibility/spherical/lazy_maps.h"
#include "core/visibility/strategy.h"

namespace cullscope::spherical {

/// The structures of one mesh; empty for a mesh without triangles or instances.
struct MeshCells {
    CellTreePointer tree;
    InnerKernelPointer kernel;
    LazyMaps maps;
    double shareFacingAway = 0.0;  ///< meanShareFacingAway of the tree
    CornerBlocks corners{};        ///< in the tree's order; where triangles are tested, of a divided tree
};

/// The structures of a scene.
struct CellScene : Structure {
    using Structure::Structure;

    [[nodiscard]] const MeshCells& meshOf(uint32_t instance) const { return meshes[scene().instances()[instance].mesh]; }

    std::vector<MeshCells> meshes;
    InstanceOctree octree;
    TriangleOrderPointer order;
};

/// Builds a scene's structures, with a kernel for each mesh of at least that many triangles; `corners`: with those of triangles.
/// Throws Error(Interrupted) on a stop request.
void buildCells(CellScene& structure, const CellTree::Options& options, size_t leastTrianglesForKernel, bool corners,
                const Progress& progress);

/// The number of meshes by the state of their kernels. `used`: whether the strategy uses kernels; else none counts as made.
[[nodiscard]] MeshStates kernelStates(const CellScene& structure, bool used);

}  // namespace cullscope::spherical
