#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/spatial/surface_bounds.h"

namespace cullscope {

/// A mesh cut into clusters of neighbouring triangles (meshlets), and a hierarchy over them, as walked by `clusters`. A node is a
/// range of the tree's order of triangles, so that neighbouring clusters are drawn as one. Coordinates are the mesh's, relative
/// to the centre of its bounding sphere. All instances of the mesh share it.
class ClusterTree {
public:
    using Node = SurfaceNode;

    static constexpr uint32_t kLeastSize = 16, kMostSize = 512, kSize = 128;
    static constexpr uint32_t kChildren = 4;  ///< of a node, at most

    /// Clusters of at most `size` triangles, kLeastSize to kMostSize. A mesh of no more is a single cluster and keeps its order.
    /// The bounds of every node are verified against its triangles after they were made: a cone that does not hold is dropped.
    /// Throws Error(Interrupted) on a stop request.
    ClusterTree(MeshPointer mesh, uint32_t size, const Progress& progress = {});

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const Sphere& sphere() const { return m_mesh->localSphere(); }
    /// False for a single cluster with the triangles in the mesh's order.
    [[nodiscard]] bool divided() const { return !m_indices.empty(); }
    /// The root first, every node before its children; the leaves are the clusters. Empty for a mesh without triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    [[nodiscard]] uint32_t deepestLevel() const { return m_deepest; }
    [[nodiscard]] size_t clusterCount() const { return m_clusters; }
    /// How many clusters have a cone narrower than 84°.
    [[nodiscard]] size_t coneCount() const { return m_cones; }

    /// Corner indices of the triangles in the tree's order, and their numbers in the mesh; both empty where it keeps the mesh's.
    [[nodiscard]] std::span<const uint32_t> indices() const { return m_indices; }
    [[nodiscard]] std::span<const uint32_t> triangleOrder() const { return m_order; }
    /// The number in the mesh of the triangle at a place.
    [[nodiscard]] uint32_t triangleAt(uint32_t place) const { return m_order.empty() ? place : m_order[place]; }
    /// The corners of a triangle of the mesh, relative to the centre.
    [[nodiscard]] TriangleCorners corners(uint32_t triangle) const;

    [[nodiscard]] uint64_t bytes() const;

private:
    void divide(const struct Meshlets& meshlets);
    void bound(const Progress& progress);
    void verify(Node& node) const;

    MeshPointer m_mesh;
    std::vector<Node> m_nodes;
    std::vector<uint32_t> m_order, m_indices;
    uint32_t m_deepest = 0;
    size_t m_clusters = 0, m_cones = 0;
};

using ClusterTreePointer = std::shared_ptr<const ClusterTree>;

}  // namespace cullscope
