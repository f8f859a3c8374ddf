#include "core/spatial/regular_octree.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace cullscope {
namespace {

/// An instance in the leaf whose number is made of an octant a level, the root's first.
struct LeafItem {
    uint32_t leaf = 0;
    uint32_t instance = 0;

    auto operator<=>(const LeafItem&) const = default;
};

bool isFinite(const Box3& box) {
    const Vec3 sum = box.min + box.max;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

Box3 boxAround(const Scene& scene, std::span<const LeafItem> items) {
    Box3 box;
    for (const LeafItem& item : items)
        if (isFinite(scene.instanceBox(item.instance))) box.add(scene.instanceBox(item.instance));
    return box;
}

/// The leaf in whose cell a point lies; the faces between two cells belong to the upper one.
uint32_t leafOf(const Vec3& point, const Box3& root, int levels) {
    uint32_t leaf = 0;
    Box3 cell = root;
    for (int level = 1; level < levels; ++level) {
        const Vec3 middle = cell.centre();
        for (int axis = 0; axis < 3; ++axis) {
            const bool upper = point[axis] >= middle[axis];
            leaf = leaf << 1 | uint32_t(upper);
            (upper ? cell.min : cell.max)[axis] = middle[axis];
        }
    }
    return leaf;
}

/// The part of a cell in an octant: a bit for each axis, x the highest.
Box3 octantOf(const Box3& cell, uint32_t octant) {
    Box3 part = cell;
    const Vec3 middle = cell.centre();
    for (int axis = 0; axis < 3; ++axis) ((octant >> (2 - axis) & 1) != 0 ? part.min : part.max)[axis] = middle[axis];
    return part;
}

}  // namespace

RegularOctree::RegularOctree(const Scene& scene, std::span<const uint32_t> instances, int levels) {
    assert(levels >= 1 && levels <= kMostLevels);
    std::vector<LeafItem> items;
    for (const uint32_t instance : instances)
        if (scene.meshOf(instance).triangleCount() > 0) items.push_back({0, instance});
    if (items.empty()) return;

    const Box3 root = boxAround(scene, items);
    for (LeafItem& item : items)
        if (isFinite(scene.instanceBox(item.instance)))
            item.leaf = leafOf(scene.instanceBox(item.instance).centre(), root, levels);
    std::ranges::sort(items);

    m_nodes.push_back({});
    m_nodes.front().count = uint32_t(items.size());
    m_cells.push_back(root);
    // Children are appended, so that the list is also the queue of nodes to divide.
    for (uint32_t number = 0; number < m_nodes.size(); ++number) {
        const Node node = m_nodes[number];
        if (node.depth + 1 == levels) continue;
        const int shift = 3 * (levels - 2 - node.depth);
        m_nodes[number].firstChild = uint32_t(m_nodes.size());
        for (uint32_t first = node.first; first < node.first + node.count;) {
            const uint32_t octant = items[first].leaf >> shift;
            uint32_t end = first;
            while (end < node.first + node.count && items[end].leaf >> shift == octant) ++end;
            Node child;
            child.first = first;
            child.count = end - first;
            child.parent = int32_t(number);
            child.depth = uint8_t(node.depth + 1);
            m_nodes.push_back(child);
            const Box3 part = octantOf(m_cells[number], octant & 7);
            m_cells.push_back(part);
            ++m_nodes[number].childCount;
            first = end;
        }
    }
    for (const LeafItem& item : items) m_order.push_back(item.instance);

    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (size_t number = m_nodes.size(); number-- > 0;) {
        Node& node = m_nodes[number];
        const auto add = [&](const Box3& box, uint64_t triangles) {
            if (isFinite(box))
                node.box.add(box);
            else
                node.box = {Vec3(-infinity), Vec3(infinity)};
            node.triangles += triangles;
        };
        if (node.leaf())
            for (const uint32_t instance : instancesOf(node))
                add(scene.instanceBox(instance), scene.meshOf(instance).triangleCount());
        for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child)
            add(m_nodes[child].box, m_nodes[child].triangles);
    }
}

}  // namespace cullscope
