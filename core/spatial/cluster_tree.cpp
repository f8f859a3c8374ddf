#include "core/spatial/cluster_tree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/message.h"
#include "core/mesh/meshlets.h"

namespace cullscope {
namespace {

/// The middles of the boxes around meshlets.
std::vector<Vec3> middlesOf(const Meshlets& meshlets, const TriangleMesh& mesh) {
    std::vector<Vec3> middles;
    middles.reserve(meshlets.size());
    for (size_t group = 0; group < meshlets.size(); ++group) {
        Box3 box;
        for (const uint32_t triangle : meshlets.of(group))
            for (size_t c = 0; c < 3; ++c) box.add(Vec3(mesh.positions()[mesh.indices()[3 * size_t(triangle) + c]]));
        middles.push_back(box.centre());
    }
    return middles;
}

/// Divides numbers of points by the middle one along the longest axis of the box around them: returns how many come first.
size_t halve(std::span<uint32_t> numbers, const std::vector<Vec3>& points) {
    Box3 box;
    for (const uint32_t number : numbers) box.add(points[number]);
    const Vec3 size = box.max - box.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = numbers.begin() + std::ptrdiff_t(numbers.size() / 2);
    std::nth_element(numbers.begin(), middle, numbers.end(), [&](uint32_t a, uint32_t b) {
        return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
    });
    return numbers.size() / 2;
}

/// Parts of numbers of points that lie close together, as counts in their order: at most kChildren, none empty.
std::vector<size_t> parted(std::span<uint32_t> numbers, const std::vector<Vec3>& points) {
    std::vector<size_t> counts{numbers.size()};
    while (counts.size() < ClusterTree::kChildren && std::ranges::all_of(counts, [](size_t count) { return count > 1; })) {
        std::vector<size_t> halves;
        for (size_t part = 0, first = 0; part < counts.size(); first += counts[part++]) {
            const size_t before = halve(numbers.subspan(first, counts[part]), points);
            halves.insert(halves.end(), {before, counts[part] - before});
        }
        counts = std::move(halves);
    }
    return counts;
}

}  // namespace

ClusterTree::ClusterTree(MeshPointer mesh, uint32_t size, const Progress& progress) : m_mesh(std::move(mesh)) {
    if (m_mesh->triangleCount() == 0) return;
    if (m_mesh->triangleCount() > size) {
        progress.tell(0.0, CULLSCOPE_TR("clusters of triangles"));
        divide(cutIntoMeshlets(*m_mesh, size, progress));
    } else {
        m_nodes.emplace_back();
        m_nodes.front().count = uint32_t(m_mesh->triangleCount());
    }
    bound(progress);
    for (const Node& node : m_nodes) {
        m_clusters += node.leaf() ? 1 : 0;
        m_cones += node.leaf() && node.hasCone() && node.hasNormals() ? 1 : 0;
    }
    progress.check();
}

TriangleCorners ClusterTree::corners(uint32_t triangle) const {
    TriangleCorners result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = Vec3(m_mesh->positions()[m_mesh->indices()[3 * size_t(triangle) + i]]) - sphere().centre;
    return result;
}

void ClusterTree::divide(const Meshlets& meshlets) {
    const std::vector<Vec3> middles = middlesOf(meshlets, *m_mesh);
    std::vector<uint32_t> groups(meshlets.size());
    std::iota(groups.begin(), groups.end(), 0U);
    // While it is divided, a node's range counts meshlets.
    m_nodes.emplace_back();
    m_nodes.front().count = uint32_t(groups.size());
    for (size_t i = 0; i < m_nodes.size(); ++i) {
        Node node = m_nodes[i];
        m_deepest = std::max(m_deepest, uint32_t(node.level));
        if (node.count == 1) continue;
        node.firstChild = uint32_t(m_nodes.size());
        uint32_t first = node.first;
        for (const size_t count : parted(std::span(groups).subspan(node.first, node.count), middles)) {
            Node child;
            child.first = first;
            child.count = uint32_t(count);
            child.level = uint8_t(node.level + 1);
            first += child.count;
            m_nodes.push_back(child);
            ++node.childCount;
        }
        m_nodes[i] = node;
    }
    std::vector<uint32_t> starts{0};
    m_order.reserve(m_mesh->triangleCount());
    for (const uint32_t group : groups) {
        const std::span<const uint32_t> triangles = meshlets.of(group);
        m_order.insert(m_order.end(), triangles.begin(), triangles.end());
        starts.push_back(uint32_t(m_order.size()));
    }
    for (Node& node : m_nodes) {
        const uint32_t first = starts[node.first];
        node.count = starts[node.first + node.count] - first;
        node.first = first;
    }
    m_indices.reserve(3 * m_order.size());
    for (const uint32_t triangle : m_order)
        for (size_t i = 0; i < 3; ++i) m_indices.push_back(m_mesh->indices()[3 * size_t(triangle) + i]);
}

void ClusterTree::bound(const Progress& progress) {
    progress.tell(0.8, CULLSCOPE_TR("bounds of the clusters"));
    const auto each = [&](auto&& use) {
        tbb::parallel_for(size_t{0}, m_nodes.size(), [&](size_t i) {
            if (!progress.stopRequested()) use(m_nodes[i]);
        });
        progress.check();
    };
    each([&](Node& node) {
        if (!node.leaf()) return;
        std::vector<TriangleCorners> triangles;
        triangles.reserve(node.count);
        for (uint32_t place = node.first; place < node.first + node.count; ++place)
            triangles.push_back(corners(triangleAt(place)));
        static_cast<SurfaceBounds&>(node) = boundsOf(triangles);
    });
    const SurfaceNodes nodes(m_nodes);
    for (size_t i = m_nodes.size(); i-- > 0;)
        if (!m_nodes[i].leaf()) static_cast<SurfaceBounds&>(m_nodes[i]) = boundsOfParts(nodes, m_nodes[i]);
    each([&](Node& node) { verify(node); });
}

void ClusterTree::verify(Node& node) const {
    for (uint32_t place = node.first; place < node.first + node.count; ++place) {
        const TriangleCorners triangle = corners(triangleAt(place));
        if (!holdsFor(node, triangle)) static_cast<SurfaceBounds&>(node) = widened(node, triangle);
    }
}

uint64_t ClusterTree::bytes() const {
    return m_nodes.size() * sizeof(Node) + (m_order.size() + m_indices.size()) * sizeof(uint32_t);
}

}  // namespace cullscope
