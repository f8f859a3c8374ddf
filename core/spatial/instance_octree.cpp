#include "core/spatial/instance_octree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/base/work_check.h"

namespace cullscope {
namespace {

using Node = InstanceOctree::Node;

/// Levels of a 64-bit Morton code.
constexpr int kLevels = 21;

struct Item {
    uint64_t code = 0;
    uint32_t instance = 0;

    bool operator<(const Item& other) const { return code != other.code ? code < other.code : instance < other.instance; }
};

/// Spreads the lowest 21 bits, with two free bits after each.
uint64_t spread(uint64_t bits) {
    bits = (bits | bits << 32) & 0x001F00000000FFFFull;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFull;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Full;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3ull;
    return (bits | bits << 2) & 0x1249249249249249ull;
}

bool finite(const Box3& box) {
    const Vec3 sum = box.min + box.max;
    return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

/// Builds the octree: its nodes are ranges of the items.
class Builder {
public:
    Builder(const Scene& scene, uint32_t leafInstances, const Progress& progress)
        : m_scene(scene), m_leafInstances(leafInstances), m_work(progress) {
        const auto count = static_cast<uint32_t>(scene.instances().size());
        for (uint32_t i = 0; i < count; ++i) {
            m_work.step();
            if (scene.meshOf(i).triangleCount() > 0) m_items.push_back({0, i});
        }
    }

    std::vector<Node> build() {
        if (m_items.empty()) return {};
        m_nodes.push_back({});
        m_nodes.front().count = uint32_t(m_items.size());
        // Children are appended, so that the list is also the queue of nodes to divide.
        for (uint32_t node = 0; node < m_nodes.size(); ++node) split(node);
        for (size_t node = m_nodes.size(); node-- > 0;) sumUp(m_nodes[node]);
        return std::move(m_nodes);
    }

    [[nodiscard]] std::vector<uint32_t> order() const {
        std::vector<uint32_t> order;
        order.reserve(m_items.size());
        for (const Item& item : m_items) order.push_back(item.instance);
        return order;
    }

private:
    [[nodiscard]] std::span<Item> itemsOf(const Node& node) { return std::span(m_items).subspan(node.first, node.count); }

    /// Sorts items by their Morton codes within the cube around their own centres; items that are not finite come first.
    void sortByCode(std::span<Item> items) {
        Box3 centres;
        for (const Item& item : items) {
            m_work.step();
            if (finite(m_scene.instanceBox(item.instance))) centres.add(m_scene.instanceBox(item.instance).centre());
        }
        const Vec3 size = centres.empty() ? Vec3(0.0) : centres.max - centres.min;
        const double edge = std::max({size.x, size.y, size.z});
        const bool divisible = edge > 0.0 && std::isfinite(edge);
        for (Item& item : items) {
            m_work.step();
            item.code = 0;
            const Box3& box = m_scene.instanceBox(item.instance);
            if (!divisible || !finite(box)) continue;
            const Vec3 cell = (box.centre() - centres.min) / edge * double((1u << kLevels) - 1);
            item.code = spread(uint64_t(cell.x)) << 2 | spread(uint64_t(cell.y)) << 1 | spread(uint64_t(cell.z));
        }
        std::sort(items.begin(), items.end(), m_work.counting(std::less<>()));
    }

    void split(uint32_t number) {
        m_work.step();
        const Node node = m_nodes[number];
        if (node.count <= m_leafInstances || node.depth == InstanceOctree::kMaxDepth) return;
        std::span<Item> items = itemsOf(node);
        // For the root, and for items with equal codes: a cube around these items alone separates what falls into one cell of a
        // cube that distant objects made large.
        if (items.front().code == items.back().code) sortByCode(items);
        const uint64_t differing = items.front().code ^ items.back().code;
        if (differing == 0) return;
        const int shift = (std::bit_width(differing) - 1) / 3 * 3;
        m_nodes[number].firstChild = uint32_t(m_nodes.size());
        for (size_t first = 0; first < items.size();) {
            const uint64_t cell = items[first].code >> shift;
            const auto end = std::partition_point(items.begin() + std::ptrdiff_t(first), items.end(),
                                                  [&](const Item& item) { return item.code >> shift == cell; });
            const auto next = size_t(end - items.begin());
            Node child;
            child.first = node.first + uint32_t(first);
            child.count = uint32_t(next - first);
            child.parent = int32_t(number);
            child.depth = uint8_t(node.depth + 1);
            m_nodes.push_back(child);
            ++m_nodes[number].childCount;
            first = next;
        }
    }

    void sumUp(Node& node) {
        const auto add = [&](const Box3& box, uint64_t triangles) {
            m_work.step();
            if (finite(box))
                node.box.add(box);
            else
                node.box = {Vec3(-std::numeric_limits<double>::infinity()), Vec3(std::numeric_limits<double>::infinity())};
            node.triangles += triangles;
        };
        if (node.leaf())
            for (const Item& item : itemsOf(node))
                add(m_scene.instanceBox(item.instance), m_scene.meshOf(item.instance).triangleCount());
        for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child)
            add(m_nodes[child].box, m_nodes[child].triangles);
    }

    const Scene& m_scene;
    uint32_t m_leafInstances;
    WorkCheck m_work;
    std::vector<Item> m_items;
    std::vector<Node> m_nodes;
};

}  // namespace

InstanceOctree::InstanceOctree(const Scene& scene, uint32_t leafInstances, const Progress& progress) {
    Builder builder(scene, leafInstances, progress);
    m_nodes = builder.build();
    m_order = builder.order();
}

}  // namespace cullscope
