#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// An octree over the instances of a scene that have triangles, by the centres of their world boxes. A node is a range of its
/// order, so that a decision about a node applies to its instances without visiting them. Nodes with one child are left out.
class InstanceOctree {
public:
    struct Node {
        Box3 box;                       ///< the tight box around its instances' boxes; infinite where one of them is not finite
        uint32_t first = 0, count = 0;  ///< its range in order()
        uint64_t triangles = 0;
        int32_t parent = -1;      ///< -1: the root
        uint32_t firstChild = 0;  ///< children are consecutive and come after their parent
        uint8_t childCount = 0;   ///< 0: a leaf
        uint8_t depth = 0;        ///< the root's is 0

        [[nodiscard]] bool leaf() const { return childCount == 0; }
    };

    /// The largest number of instances in a leaf where nothing else is asked for, unless their centres coincide or the leaf lies
    /// at kMaxDepth.
    static constexpr uint32_t kLeafInstances = 4;
    static constexpr uint8_t kMaxDepth = 48;

    InstanceOctree() = default;
    /// O(n log n). Equal scenes give equal trees. Throws Error(Interrupted) soon after a stop is requested.
    explicit InstanceOctree(const Scene& scene, uint32_t leafInstances = kLeafInstances, const Progress& progress = {});

    /// The root first; empty where no instance has triangles.
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    /// Instance numbers in Morton order of the octree's cells.
    [[nodiscard]] const std::vector<uint32_t>& order() const { return m_order; }
    /// The instances of a node.
    [[nodiscard]] std::span<const uint32_t> instancesOf(const Node& node) const {
        return std::span(m_order).subspan(node.first, node.count);
    }
    [[nodiscard]] uint64_t bytes() const { return m_nodes.size() * sizeof(Node) + m_order.size() * sizeof(uint32_t); }

private:
    std::vector<Node> m_nodes;
    std::vector<uint32_t> m_order;
};

}  // namespace cullscope
