#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/spatial/direction_map.h"

namespace cullscope {

/// A quadtree over a map of directions from the centre of a mesh's bounding sphere. Each triangle belongs to the cell of its
/// centroid, and a node knows of all triangles in its cells where they lie and where they face: what `spherical-lossless` walks.
/// Coordinates are the mesh's, from that centre.
class CellTree {
public:
    /// All bounds hold of the float positions as they are, rounded outward.
    struct Node {
        Vec3f low{0.0f}, high{0.0f};    ///< box around the whole triangles
        Vec3f coneAxis{0.0f};           ///< unit; around it lie the triangles' unit normals,
        float coneCosine = 2.0f;        ///< within an angle of this cosine; 2: there is no such cone narrower than 84°
        float coneSine = 0.0f;          ///< of the same
        float planeMargin = 0.0f;       ///< no triangle's plane passes the box's middle farther than this on the side of the eye
        float leastHeight = 0.0f;       ///< the smallest altitude of a triangle
        uint32_t first = 0, count = 0;  ///< its triangles' places in the order
        uint32_t firstChild = 0;        ///< the others follow it
        uint32_t code = 0;              ///< of its cell (mortonCode)
        uint8_t level = 0;
        uint8_t childCount = 0;  ///< 0: a leaf

        [[nodiscard]] MapCell cell() const { return mapCell(code, level); }
    };

    struct Options {
        MapLayout layout = MapLayout::Octahedral;
        uint32_t level = 0;  ///< of the finest cells, at most kFinestLevel; 0: opened down to about kTrianglesALeaf triangles
        size_t fewest = 0;   ///< a mesh of fewer triangles is one cell, and keeps its order
    };
    static constexpr uint32_t kTrianglesALeaf = 48;
    /// In parallel; the result does not depend on the number of threads. Throws Error(Interrupted) on stop.
    CellTree(MeshPointer mesh, const Options& options, const Progress& progress = {});

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const Sphere& sphere() const { return m_mesh->localSphere(); }
    /// False: one cell, the triangles in the mesh's order.
    [[nodiscard]] bool divided() const { return m_mesh->triangleCount() >= m_options.fewest; }
    [[nodiscard]] MapLayout layout() const { return m_options.layout; }
    /// The root first, every node before its children; empty: the mesh has no triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    [[nodiscard]] uint32_t deepestLevel() const { return m_deepest; }
    [[nodiscard]] size_t leafCount() const;

    /// Corners of the triangles in the order, so that the cells below a node are one range.
    [[nodiscard]] std::span<const uint32_t> indices() const { return divided() ? m_indices : m_mesh->indices(); }
    /// The mesh's number of the triangle at each place.
    [[nodiscard]] std::span<const uint32_t> triangleOrder() const { return m_order; }
    /// Relative to the centre.
    [[nodiscard]] std::array<Vec3, 3> corners(uint32_t triangle) const;
    /// The leaf whose cell holds a direction; none: no triangle's centroid lies there.
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
    std::vector<uint32_t> m_codes;  ///< by place, of level kFinestLevel; only while it is built
    std::vector<uint32_t> m_order;
    std::vector<uint32_t> m_indices;
    std::vector<Node> m_nodes;
};

using CellTreePointer = std::shared_ptr<const CellTree>;

}  // namespace cullscope
