#include "core/visibility/occlusion/pvs_cells.h"

#include <algorithm>
#include <cmath>

namespace cullscope::occlusion {
namespace {

/// Of the scene's diagonal: by how much the cells reach beyond its box.
constexpr double kBeyond = 0x1p-10;

/// A triangle, by the box around it and the plane in which it lies.
struct Crossing {
    Box3 box;
    Vec3 normal;
    double distance = 0.0, room = 0.0;
    uint32_t instance = 0;

    /// False only where the triangle has no point in the box.
    [[nodiscard]] bool mayCross(const Box3& cell) const {
        if (glm::any(glm::lessThan(box.max, cell.min)) || glm::any(glm::greaterThan(box.min, cell.max))) return false;
        const double rounding = 0x1p-44 * (glm::length(cell.centre()) + glm::length(cell.halfExtent()));
        return std::abs(glm::dot(normal, cell.centre()) - distance) <=
               glm::dot(glm::abs(normal), cell.halfExtent()) + room + rounding;
    }
};

class Division {
public:
    Division(ViewCells& cells, double largest, int halvings, const Progress& progress)
        : m_cells(cells), m_largest(largest), m_halvings(halvings), m_progress(progress) {}

    /// The child that stands for a box: a node, or a region. `halved`: how often it was halved for its surfaces alone.
    int32_t divide(const Box3& box, std::vector<Crossing> crossing, int halved) {
        m_progress.check();
        const Vec3 size = box.max - box.min;
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const bool tooLarge = size[axis] > m_largest;
        if (!tooLarge && (crossing.empty() || halved == m_halvings)) return region(box, crossing);
        const double middle = box.centre()[axis];
        if (!(middle > box.min[axis]) || !(middle < box.max[axis])) return region(box, crossing);
        const size_t number = m_cells.nodes.size();
        m_cells.nodes.emplace_back();
        m_cells.nodes[number].normal = Vec3(0.0);
        m_cells.nodes[number].normal[axis] = 1.0;
        m_cells.nodes[number].distance = middle;
        for (const int side : {0, 1}) {
            Box3 half = box;
            (side == 0 ? half.min : half.max)[axis] = middle;
            std::vector<Crossing> in;
            std::ranges::copy_if(crossing, std::back_inserter(in), [&](const Crossing& one) { return one.mayCross(half); });
            const int32_t child = divide(half, std::move(in), tooLarge ? halved : halved + 1);
            m_cells.nodes[number].children[size_t(side)] = child;
        }
        return int32_t(number);
    }

private:
    int32_t region(const Box3& box, const std::vector<Crossing>& crossing) {
        std::vector<uint32_t> objects;
        for (const Crossing& one : crossing) objects.push_back(one.instance);
        std::ranges::sort(objects);
        objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
        m_cells.boxes.push_back(box);
        m_cells.crossing.push_back(std::move(objects));
        return -int32_t(m_cells.boxes.size());
    }

    ViewCells& m_cells;
    double m_largest;
    int m_halvings;
    const Progress& m_progress;
};

/// Every triangle of the scene, with the room by which a picture may move its corners.
std::vector<Crossing> crossings(const Scene& scene, const Progress& progress) {
    std::vector<Crossing> result;
    result.reserve(scene.triangleCount());
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        progress.check();
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat4& placed = scene.instances()[i].worldFromMesh;
        const double rounding = scene.pictureRounding(scene.instances()[i]);
        for (size_t t = 0; t < mesh.triangleCount(); ++t) {
            Crossing triangle;
            triangle.instance = i;
            std::array<Vec3, 3> corners;
            for (size_t c = 0; c < 3; ++c)
                triangle.box.add(corners[c] = Vec3(placed * Vec4(mesh.position(mesh.indices()[3 * t + c]), 1.0)));
            triangle.room = rounding + 0x1p-40 * (glm::length(corners[0]) + triangle.box.diagonal());
            const Vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
            const double length = glm::length(normal);
            // A triangle without a plane counts wherever its box does.
            const bool plane = length > 0.0 && std::isfinite(length);
            triangle.normal = plane ? normal / length : Vec3(0.0);
            triangle.distance = plane ? glm::dot(triangle.normal, corners[0]) : 0.0;
            triangle.box.min -= Vec3(triangle.room);
            triangle.box.max += Vec3(triangle.room);
            result.push_back(triangle);
        }
    }
    return result;
}

}  // namespace

std::optional<ViewCells> viewCells(const Scene& scene, const CellOptions& options, const Progress& progress) {
    const auto drawn = std::ranges::count_if(
        scene.instances(), [&](const Instance& instance) { return scene.meshes()[instance.mesh]->triangleCount() > 0; });
    const Box3& bounds = scene.bounds();
    if (drawn < 2 || bounds.empty() || !(bounds.diagonal() > 0.0) || !std::isfinite(bounds.diagonal())) return std::nullopt;
    ViewCells cells;
    const Vec3 beyond(bounds.diagonal() * kBeyond);
    cells.within = {bounds.min - beyond, bounds.max + beyond};
    const Vec3 size = cells.within.max - cells.within.min;
    // Halving never meets a size exactly, so a little room tells how often.
    const double largest = std::max({size.x, size.y, size.z}) / options.along * (1.0 + 1e-9);
    const int32_t root = Division(cells, largest, options.halvings, progress).divide(cells.within, crossings(scene, progress), 0);
    // A tree has a node, also where it has one region alone.
    if (root < 0) cells.nodes.push_back({Vec3(1.0, 0.0, 0.0), cells.within.min.x, {root, root}});
    return cells;
}

std::vector<std::vector<uint32_t>> neighbours(const ViewCells& cells) {
    std::vector<std::vector<uint32_t>> result(cells.boxes.size());
    std::vector<uint32_t> byX(cells.boxes.size());
    for (uint32_t i = 0; i < byX.size(); ++i) byX[i] = i;
    std::ranges::sort(byX, {}, [&](uint32_t i) { return cells.boxes[i].min.x; });
    for (size_t i = 0; i < byX.size(); ++i) {
        const Box3& box = cells.boxes[byX[i]];
        for (size_t j = i + 1; j < byX.size() && cells.boxes[byX[j]].min.x <= box.max.x; ++j) {
            const Box3& other = cells.boxes[byX[j]];
            if (other.min.y > box.max.y || other.max.y < box.min.y || other.min.z > box.max.z || other.max.z < box.min.z)
                continue;
            result[byX[i]].push_back(byX[j]);
            result[byX[j]].push_back(byX[i]);
        }
    }
    for (std::vector<uint32_t>& list : result) std::ranges::sort(list);
    return result;
}

}  // namespace cullscope::occlusion
