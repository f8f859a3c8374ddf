#pragma once

#include <array>
#include <string>

#include "core/spatial/bsp_tree.h"

namespace cullscope {

/// The cells into which a tree divides space.
struct BspCells {
    std::vector<uint32_t> leaves;  ///< nodes: the cells below all given planes, those behind the planes first
    std::vector<std::optional<size_t>>
        leafOf;                  ///< by node: the place among `leaves` of the one that it lies in; none: above them
    std::vector<uint32_t> rank;  ///< by node: its number in the order from before to behind all planes

    /// The leaf that a node lies in; the node itself where there is none.
    [[nodiscard]] uint32_t cellOf(uint32_t node) const { return leafOf[node] ? leaves[*leafOf[node]] : node; }
    /// C1, C2, …: of a place among the leaves.
    [[nodiscard]] static std::string leafName(size_t place) { return "C" + std::to_string(place + 1); }
};

/// `planes`: how many levels of given planes the tree has (BspPlane::Given); 0: every node is a cell of its own.
[[nodiscard]] BspCells cellsOf(const BspTree& tree, size_t planes);

/// A given plane's name, or that of the leaf below all of them, or C1.7: node 7 of those that leaf C1 has; else its number.
[[nodiscard]] std::string nodeName(const BspTree& tree, const BspCells& cells, const Scene& scene, uint32_t node);

/// The outline of the part of a node's plane that lies in its cell and in a box; empty where there is none. Rounded.
[[nodiscard]] std::vector<Vec3> planeInCell(const BspTree& tree, uint32_t number, const Box3& box);

/// The corners in world coordinates of the triangles that a part is drawn as.
[[nodiscard]] std::vector<std::array<Vec3, 3>> trianglesOf(const BspTree& tree, const BspTree::Part& part, const Scene& scene);

/// The node that holds a triangle of the scene at a point of it; none: the tree has no part of it.
[[nodiscard]] std::optional<uint32_t> nodeAt(const BspTree& tree, const Scene& scene, uint64_t triangle, const Vec3& point);

}  // namespace cullscope
