#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/spatial/direction_map.h"
#include "core/spatial/surface_bounds.h"

namespace cullscope {

/// A quadtree over a map of directions from the centre of a mesh's bounding sphere, as walked by `spherical-lossless`. Each
/// triangle belongs to the cell of its centroid, and a node has bounds on the positions and normals of all triangles in its
/// cells. Coordinates are the mesh's, relative to that centre.
class CellTree {
public:
    /// All bounds are for the float positions as stored, rounded outward.
    struct Node : SurfaceNode {
        uint32_t code = 0;  ///< Morton code of its cell

        [[nodiscard]] MapCell cell() const { return mapCell(code, level); }
    };

    struct Options {
        MapLayout layout = MapLayout::Octahedral;
        uint32_t level = 0;  ///< level of the finest cells, at most kFinestLevel; 0: divided down to about kTrianglesALeaf
                             ///< triangles
        size_t fewest = 0;   ///< a mesh of fewer triangles is a single cell and keeps its order
    };
    static constexpr uint32_t kTrianglesALeaf = 48;
    /// Built in parallel; the result does not depend on the number of threads. Throws Error(Interrupted) on a stop request.
    CellTree(MeshPointer mesh, const Options& options, const Progress& progress = {});

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const Sphere& sphere() const { return m_mesh->localSphere(); }
    /// False for a single cell with the triangles in the mesh's order.
    [[nodiscard]] bool divided() const { return m_mesh->triangleCount() >= m_options.fewest; }
    [[nodiscard]] MapLayout layout() const { return m_options.layout; }
    /// The root first, every node before its children; empty for a mesh without triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    [[nodiscard]] uint32_t deepestLevel() const { return m_deepest; }
    [[nodiscard]] size_t leafCount() const;

    /// Corner indices of the triangles in the tree's order, so that the triangles below a node are one range.
    [[nodiscard]] std::span<const uint32_t> indices() const { return divided() ? m_indices : m_mesh->indices(); }
    /// The number in the mesh of the triangle at each place.
    [[nodiscard]] std::span<const uint32_t> triangleOrder() const { return m_order; }
    /// The corners of a triangle relative to the centre.
    [[nodiscard]] std::array<Vec3, 3> corners(uint32_t triangle) const;
    /// The leaf whose cell contains a direction; null where no triangle's centroid lies in that cell.
    [[nodiscard]] const Node* leafAt(const Vec3& direction) const;

    [[nodiscard]] uint64_t bytes() const;

private:
    void sortTriangles(const Progress& progress);
    void divide();
    void bound(const Progress& progress);
    void boundLeaf(Node& node) const;
    void boundInner(Node& node) const;

    MeshPointer m_mesh;
    Options m_options;
    uint32_t m_deepest = 0;
    std::vector<uint32_t> m_codes;  ///< by place, at level kFinestLevel; only during the build
    std::vector<uint32_t> m_order;
    std::vector<uint32_t> m_indices;
    std::vector<Node> m_nodes;
};

using CellTreePointer = std::shared_ptr<const CellTree>;

}  // namespace cullscope
