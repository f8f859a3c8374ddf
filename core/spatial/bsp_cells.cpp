#include "core/spatial/bsp_cells.h"

#include <algorithm>

#include "core/frame/named_parts.h"

namespace cullscope {
namespace {

/// A convex polygon, cut to the front of a plane.
std::vector<Vec3> clippedToFront(const std::vector<Vec3>& polygon, const Vec3& normal, double offset) {
    std::vector<Vec3> result;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = glm::dot(normal, a) + offset, db = glm::dot(normal, b) + offset;
        if (da >= 0.0) result.push_back(a);
        if (da * db < 0.0) result.push_back(a + (b - a) * (da / (da - db)));
    }
    return result;
}

}  // namespace

BspCells cellsOf(const BspTree& tree, size_t planes) {
    const std::vector<BspTree::Node>& nodes = tree.nodes();
    BspCells cells;
    cells.leafOf.resize(nodes.size());
    cells.rank.resize(nodes.size());
    uint32_t next = 0;
    const auto number = [&](int32_t node) { cells.rank[size_t(node)] = next++; };
    std::vector<std::pair<int32_t, bool>> open;  // a node, and whether what is before it was numbered
    if (!nodes.empty()) open.emplace_back(0, false);
    while (!open.empty()) {
        const auto [node, frontDone] = open.back();
        open.pop_back();
        if (node == BspTree::kNone) continue;
        if (frontDone) {
            number(node);
            continue;
        }
        open.emplace_back(nodes[size_t(node)].back, false);
        open.emplace_back(node, true);
        open.emplace_back(nodes[size_t(node)].front, false);
    }
    for (uint32_t node = 0; planes > 0 && node < nodes.size(); ++node)
        if (nodes[node].depth == planes) cells.leaves.push_back(node);
    std::ranges::sort(cells.leaves, std::greater<>(), [&](uint32_t node) { return cells.rank[node]; });
    for (size_t leaf = 0; leaf < cells.leaves.size(); ++leaf) cells.leafOf[cells.leaves[leaf]] = leaf;
    // A parent has a lower number than its children.
    for (uint32_t node = 1; node < nodes.size(); ++node)
        if (const auto& above = cells.leafOf[size_t(nodes[node].parent)]) cells.leafOf[node] = above;
    return cells;
}

std::string nodeName(const BspTree& tree, const BspCells& cells, const Scene& scene, uint32_t node) {
    if (!cells.leaves.empty() && !cells.leafOf[node]) return scene.planes()[tree.nodes()[node].depth].name;
    if (!cells.leafOf[node]) return std::to_string(node);
    const size_t leaf = *cells.leafOf[node];
    return BspCells::leafName(leaf) + (cells.leaves[leaf] == node ? std::string() : "." + std::to_string(node));
}

std::vector<Vec3> planeInCell(const BspTree& tree, uint32_t number, const Box3& box) {
    const BspTree::Node& node = tree.nodes()[number];
    if (node.leaf) return {};
    const Vec3 normal = node.plane.normal, centre = box.centre();
    const Vec3 side = glm::normalize(glm::cross(normal, std::abs(normal.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
    const Vec3 other = glm::cross(normal, side);
    const Vec3 foot = centre - normal * node.plane.distance(centre);
    const double reach = std::max(box.diagonal(), 1e-300);
    std::vector<Vec3> polygon{foot - (side + other) * reach, foot + (side - other) * reach, foot + (side + other) * reach,
                              foot - (side - other) * reach};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 inward(0.0);
        inward[axis] = 1.0;
        polygon = clippedToFront(polygon, inward, -box.min[axis]);
        polygon = clippedToFront(polygon, -inward, box.max[axis]);
    }
    auto below = int32_t(number);
    for (int32_t above = node.parent; above != BspTree::kNone; above = tree.nodes()[size_t(above)].parent) {
        const BspTree::Node& cutting = tree.nodes()[size_t(above)];
        const double sign = cutting.front == below ? 1.0 : -1.0;
        polygon = clippedToFront(polygon, cutting.plane.normal * sign, -sign * glm::dot(cutting.plane.normal, cutting.plane.a));
        below = above;
    }
    return polygon;
}

std::vector<std::array<Vec3, 3>> trianglesOf(const BspTree& tree, const BspTree::Part& part, const Scene& scene) {
    const auto instance = uint32_t(scene.instanceOf(part.triangle));
    std::vector<std::array<Vec3, 3>> triangles;
    for (uint32_t i = 0; i < part.count; ++i) triangles.push_back(worldCorners(tree.drawn(), part.first + i, scene, instance));
    return triangles;
}

std::optional<uint32_t> nodeAt(const BspTree& tree, const Scene& scene, uint64_t triangle, const Vec3& point) {
    std::optional<size_t> best;
    double away = 0.0;
    const std::vector<BspTree::Part>& parts = tree.parts();
    for (size_t i = 0; i < parts.size() - tree.flatParts().size(); ++i) {
        if (parts[i].triangle != triangle) continue;
        for (const auto& corners : trianglesOf(tree, parts[i], scene)) {
            const double outside = shareOutside(corners, point);
            if (best && outside >= away) continue;
            best = i;
            away = outside;
        }
    }
    if (!best) return std::nullopt;
    const auto after = std::ranges::upper_bound(tree.nodes(), *best, {}, &BspTree::Node::firstPart);
    return uint32_t(after - tree.nodes().begin()) - 1;
}

}  // namespace cullscope
