#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/spatial/instance_octree.h"

namespace cullscope {

/// An octree of a given number of levels over some instances of a scene (Du et al. 2017, Algorithm 3). The root's cell is the box
/// around their boxes; each level halves it along all three axes. An instance belongs to the leaf in whose cell the centre of its
/// box lies, and may reach over the cell. Cells without instances have no node; all leaves are at the last level.
class RegularOctree {
public:
    using Node = InstanceOctree::Node;

    static constexpr int kMostLevels = 8;

    RegularOctree() = default;
    /// `levels`: 1 is the root alone, h gives up to 8^(h − 1) leaves; from 1 to kMostLevels. Instances without triangles are left
    /// out. An instance whose box is not finite belongs to the first leaf, whose box is then infinite. Equal scenes give equal
    /// trees.
    RegularOctree(const Scene& scene, std::span<const uint32_t> instances, int levels);

    /// The root first, children consecutive and after their parent; empty where there is no instance. `Node::box` is the tight
    /// box around the node's instances.
    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    /// By node: its cell.
    [[nodiscard]] const std::vector<Box3>& cells() const { return m_cells; }
    /// Instance numbers by leaf, ascending in each.
    [[nodiscard]] const std::vector<uint32_t>& order() const { return m_order; }
    [[nodiscard]] std::span<const uint32_t> instancesOf(const Node& node) const {
        return std::span(m_order).subspan(node.first, node.count);
    }
    [[nodiscard]] uint64_t bytes() const {
        return m_nodes.size() * sizeof(Node) + m_cells.size() * sizeof(Box3) + m_order.size() * sizeof(uint32_t);
    }

private:
    std::vector<Node> m_nodes;
    std::vector<Box3> m_cells;
    std::vector<uint32_t> m_order;
};

}  // namespace cullscope
