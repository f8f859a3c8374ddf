#include "core/spatial/cell_tree.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/base/message.h"

namespace cullscope {
namespace {

using Range = tbb::blocked_range<uint32_t>;

constexpr uint32_t kTrianglesPerPass = 8192;
constexpr uint32_t kLeavesAPart = 64;
}  // namespace

CellTree::CellTree(MeshPointer mesh, const Options& options, const Progress& progress)
    : m_mesh(std::move(mesh)), m_options(options) {
    if (m_mesh->triangleCount() == 0) return;
    if (divided()) {
        sortTriangles(progress);
    } else {
        m_order.resize(m_mesh->triangleCount());
        std::iota(m_order.begin(), m_order.end(), 0U);
    }
    divide();
    m_codes = {};
    bound(progress);
    progress.check();
}

std::array<Vec3, 3> CellTree::corners(uint32_t triangle) const {
    std::array<Vec3, 3> result;
    for (size_t i = 0; i < 3; ++i)
        result[i] = Vec3(m_mesh->positions()[m_mesh->indices()[3 * size_t(triangle) + i]]) - sphere().centre;
    return result;
}

void CellTree::sortTriangles(const Progress& progress) {
    progress.tell(0.0, CULLSCOPE_TR("order of the triangles"));
    const auto count = uint32_t(m_mesh->triangleCount());
    std::vector<uint64_t> keys(count);  // code in the upper half, triangle number in the lower
    tbb::parallel_for(Range(0, count, kTrianglesPerPass), [&](const Range& part) {
        if (progress.stopRequested()) return;
        for (uint32_t triangle = part.begin(); triangle < part.end(); ++triangle) {
            const std::array<Vec3, 3> points = corners(triangle);
            const Vec3 centroid = points[0] + points[1] + points[2];
            const MapCell cell = centroid == Vec3(0.0) ? MapCell{} : mapCellOf(m_options.layout, centroid, kFinestLevel);
            keys[triangle] = uint64_t(mortonCode(cell.x, cell.y)) << 32 | triangle;
        }
    });
    progress.check();
    tbb::parallel_sort(keys.begin(), keys.end());
    progress.check();
    m_codes.resize(count);
    m_order.resize(count);
    m_indices.resize(3 * size_t(count));
    tbb::parallel_for(Range(0, count, kTrianglesPerPass), [&](const Range& part) {
        for (uint32_t place = part.begin(); place < part.end(); ++place) {
            m_codes[place] = uint32_t(keys[place] >> 32);
            m_order[place] = uint32_t(keys[place]);
            for (size_t i = 0; i < 3; ++i) m_indices[3 * size_t(place) + i] = m_mesh->indices()[3 * size_t(m_order[place]) + i];
        }
    });
}

void CellTree::divide() {
    const uint32_t finest = m_options.level == 0 ? kFinestLevel : std::min(m_options.level, kFinestLevel);
    const uint32_t few = m_options.level == 0 ? kTrianglesALeaf : 1;
    const auto codeAt = [](uint32_t code, uint32_t level) { return code >> (2 * (kFinestLevel - level)); };
    Node root;
    root.count = uint32_t(m_order.size());
    m_nodes.push_back(root);
    if (!divided()) return;
    for (size_t i = 0; i < m_nodes.size(); ++i) {
        Node node = m_nodes[i];
        const auto begin = m_codes.begin() + node.first, end = begin + node.count;
        // The smallest cell that contains all its triangles: this skips chains of nodes with one child.
        while (node.level < finest && codeAt(*begin, node.level + 1U) == codeAt(*(end - 1), node.level + 1U))
            node.code = codeAt(*begin, ++node.level);
        if (node.level < finest && node.count > few) {
            node.firstChild = uint32_t(m_nodes.size());
            for (auto from = begin; from != end;) {
                Node child;
                child.level = uint8_t(node.level + 1);
                child.code = codeAt(*from, child.level);
                const auto to =
                    std::partition_point(from, end, [&](uint32_t code) { return codeAt(code, child.level) == child.code; });
                child.first = uint32_t(from - m_codes.begin());
                child.count = uint32_t(to - from);
                m_nodes.push_back(child);
                ++node.childCount;
                from = to;
            }
        }
        m_deepest = std::max(m_deepest, uint32_t(node.level));
        m_nodes[i] = node;
    }
}

void CellTree::bound(const Progress& progress) {
    progress.tell(0.6, CULLSCOPE_TR("bounds of the cells"));
    tbb::parallel_for(Range(0, uint32_t(m_nodes.size()), kLeavesAPart), [&](const Range& part) {
        if (progress.stopRequested()) return;
        for (uint32_t node = part.begin(); node < part.end(); ++node)
            if (m_nodes[node].childCount == 0) boundLeaf(m_nodes[node]);
    });
    progress.check();
    for (size_t node = m_nodes.size(); node-- > 0;)
        if (m_nodes[node].childCount > 0) boundInner(m_nodes[node]);
}

void CellTree::boundLeaf(Node& node) const {
    std::vector<TriangleCorners> triangles;
    triangles.reserve(node.count);
    for (uint32_t place = node.first; place < node.first + node.count; ++place) triangles.push_back(corners(m_order[place]));
    static_cast<SurfaceBounds&>(node) = boundsOf(triangles);
}

void CellTree::boundInner(Node& node) const { static_cast<SurfaceBounds&>(node) = boundsOfParts(SurfaceNodes(m_nodes), node); }

size_t CellTree::leafCount() const {
    return size_t(std::count_if(m_nodes.begin(), m_nodes.end(), [](const Node& node) { return node.childCount == 0; }));
}

const CellTree::Node* CellTree::leafAt(const Vec3& direction) const {
    if (m_nodes.empty()) return nullptr;
    const MapCell cell = mapCellOf(m_options.layout, direction, kFinestLevel);
    const uint32_t code = mortonCode(cell.x, cell.y);
    const auto holds = [&](const Node& node) { return code >> (2 * (kFinestLevel - node.level)) == node.code; };
    const Node* node = m_nodes.data();
    while (holds(*node)) {
        if (node->childCount == 0) return node;
        const std::span<const Node> children(m_nodes.data() + node->firstChild, node->childCount);
        const auto child = std::find_if(children.begin(), children.end(), holds);
        if (child == children.end()) return nullptr;
        node = &*child;
    }
    return nullptr;
}

uint64_t CellTree::bytes() const {
    return m_nodes.size() * sizeof(Node) + (m_order.size() + m_indices.size()) * sizeof(uint32_t);
}

}  // namespace cullscope
