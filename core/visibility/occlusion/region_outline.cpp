#include "core/visibility/occlusion/region_outline.h"

#include <cmath>
#include <utility>

namespace cullscope::occlusion {
namespace {

/// A half space with the points where normal·p ≥ distance.
struct Side {
    Vec3 normal;
    double distance = 0.0;
};

/// The planes on the way from the root to a region, each with the side on which the region lies.
bool findWay(std::span<const RegionSets::Node> nodes, int32_t at, uint32_t region, std::vector<Side>& way) {
    if (at < 0) return uint32_t(-1 - at) == region;
    const RegionSets::Node& node = nodes[size_t(at)];
    for (const double sign : {1.0, -1.0}) {
        way.push_back({sign * node.normal, sign * node.distance});
        if (findWay(nodes, node.children[sign > 0.0 ? 0 : 1], region, way)) return true;
        way.pop_back();
    }
    return false;
}

std::vector<Vec3> clipped(const std::vector<Vec3>& polygon, const Side& side, double room) {
    std::vector<Vec3> result;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double inA = glm::dot(side.normal, a) - side.distance + room, inB = glm::dot(side.normal, b) - side.distance + room;
        if (inA >= 0.0) result.push_back(a);
        if ((inA >= 0.0) != (inB >= 0.0)) result.push_back(a + inA / (inA - inB) * (b - a));
    }
    return result;
}

/// A square on the plane that is larger than the box.
std::vector<Vec3> squareOn(const Side& side, const Box3& box) {
    const Vec3 normal = glm::normalize(side.normal);
    const Vec3 centre =
        box.centre() - normal * ((glm::dot(side.normal, box.centre()) - side.distance) / glm::length(side.normal));
    const Vec3 other = std::abs(normal.x) < 0.7 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    const Vec3 u = glm::normalize(glm::cross(normal, other)) * box.diagonal(), v = glm::cross(normal, u);
    return {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
}

}  // namespace

std::vector<std::array<Vec3, 2>> regionOutline(const RegionSets& sets, uint32_t region, const Box3& box) {
    std::vector<Side> sides;
    if (box.empty() || !findWay(sets.nodes(), 0, region, sides)) return {};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal(0.0);
        normal[axis] = 1.0;
        sides.push_back({normal, box.min[axis]});
        sides.push_back({-normal, -box.max[axis]});
    }
    // Faces that only touch the region are not its own; rounding alone must not part those that are.
    const double room = box.diagonal() * 1e-9;
    std::vector<std::array<Vec3, 2>> edges;
    for (size_t i = 0; i < sides.size(); ++i) {
        std::vector<Vec3> face = squareOn(sides[i], box);
        for (size_t j = 0; j < sides.size() && face.size() >= 3; ++j)
            if (j != i) face = clipped(face, sides[j], room);
        if (face.size() < 3) continue;
        for (size_t j = 0; j < face.size(); ++j) edges.push_back({face[j], face[(j + 1) % face.size()]});
    }
    return edges;
}

}  // namespace cullscope::occlusion
