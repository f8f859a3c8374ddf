#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

using TriangleCorners = std::array<Vec3, 3>;

/// Bounds on the positions and normals of some triangles of a mesh, in its coordinates relative to a centre. They hold for the
/// positions as given, rounded outward.
struct SurfaceBounds {
    Vec3f low{0.0f}, high{0.0f};  ///< box around all of its triangles, in full
    Vec3f coneAxis{0.0f};         ///< unit; the triangles' unit normals lie around it,
    float coneCosine = 2.0f;      ///< within an angle of this cosine; 2: no such cone is narrower than 84°
    float coneSine = 0.0f;        ///< sine of that angle
    float planeMargin = 0.0f;     ///< the box's middle lies at most this far on the front side of any of its triangles' planes
    float leastHeight = 0.0f;     ///< the smallest altitude of its triangles

    [[nodiscard]] bool hasCone() const { return coneCosine <= 1.0f; }
    /// Whether any of its triangles has a normal.
    [[nodiscard]] bool hasNormals() const { return coneAxis != Vec3f(0.0f); }
    [[nodiscard]] Vec3 middle() const { return 0.5 * (Vec3(low) + Vec3(high)); }
};

/// A node of a tree over a mesh's triangles: a range of the tree's order of them, and their bounds.
struct SurfaceNode : SurfaceBounds {
    uint32_t first = 0, count = 0;  ///< range of its triangles in the tree's order
    uint32_t firstChild = 0;        ///< index of its first child; the others follow
    uint8_t level = 0;
    uint8_t childCount = 0;  ///< 0: a leaf

    [[nodiscard]] bool leaf() const { return childCount == 0; }
};

/// The nodes of a tree, whatever its own nodes have besides. A view of an array.
class SurfaceNodes {
public:
    template <typename Node>
    explicit SurfaceNodes(const std::vector<Node>& nodes)
        : m_first(reinterpret_cast<const std::byte*>(static_cast<const SurfaceNode*>(nodes.data()))),
          m_stride(sizeof(Node)),
          m_size(nodes.size()) {}

    [[nodiscard]] size_t size() const { return m_size; }
    [[nodiscard]] const SurfaceNode& operator[](size_t number) const {
        return *reinterpret_cast<const SurfaceNode*>(m_first + number * m_stride);
    }

private:
    const std::byte* m_first;
    size_t m_stride, m_size;
};

/// The bounds of triangles.
[[nodiscard]] SurfaceBounds boundsOf(std::span<const TriangleCorners> triangles);
/// The bounds of a node by those of its children.
[[nodiscard]] SurfaceBounds boundsOfParts(const SurfaceNodes& nodes, const SurfaceNode& node);
/// The share of a tree's triangles that lie in leaves whose normal cone faces away from an eye, on average over all directions
/// to a distant one: (1 − sin a) / 2 of the directions for a cone of half the opening angle a.
[[nodiscard]] double meanShareFacingAway(const SurfaceNodes& nodes);
/// Whether bounds hold for a triangle: its corners lie in the box, its normal in the cone, where there is one, the box's middle
/// not farther before its plane than the margin allows, and no altitude of it is smaller than the smallest.
[[nodiscard]] bool holdsFor(const SurfaceBounds& bounds, const TriangleCorners& triangle);
/// Bounds that hold for a triangle, too: the box grown by it, and no cone.
[[nodiscard]] SurfaceBounds widened(const SurfaceBounds& bounds, const TriangleCorners& triangle);

}  // namespace cullscope
