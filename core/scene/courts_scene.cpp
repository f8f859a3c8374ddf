#include "core/scene/courts_scene.h"

#include <algorithm>
#include <array>

#include "core/base/message.h"

namespace cullscope {
namespace {

// Shares of the longer side of the scene's ground.
constexpr double kThickness = 0.01;  // of a wall
constexpr double kGap = 0.02;        // between the scene and its walls
constexpr double kAlley = 0.02;      // between the walls of neighbours

/// The axes of the ground, and the one upwards.
struct Axes {
    int right, ahead, up;

    explicit Axes(UpAxis axis) : right(0), ahead(axis == UpAxis::Z ? 1 : 2), up(axis == UpAxis::Z ? 2 : 1) {}
};

/// Around a side of the cube.
constexpr std::array<std::array<float, 2>, 4> kCornersOfASide{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// A cube from 0 to 1, each side with vertices of its own so that it is shaded flat. Closed.
MeshPointer cube() {
    TriangleMesh::Data data;
    data.name = "wall";
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {0.0F, 1.0F}) {
            const auto first = static_cast<uint32_t>(data.positions.size());
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (const auto& [a, b] : kCornersOfASide) {
                Vec3f position(0.0F), normal(0.0F);
                position[axis] = side;
                position[u] = a;
                position[v] = b;
                normal[axis] = 2.0F * side - 1.0F;
                data.positions.push_back(position);
                data.normals.push_back(normal);
            }
            // Counter-clockwise seen from outside.
            if (side > 0.0F)
                data.indices.insert(data.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
            else
                data.indices.insert(data.indices.end(), {first, first + 2, first + 1, first, first + 3, first + 2});
        }
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// The cube at a corner, as large as `size`.
Mat4 placed(const Vec3& corner, const Vec3& size) {
    Mat4 place(1.0);
    for (int axis = 0; axis < 3; ++axis) place[axis][axis] = size[axis];
    place[3] = Vec4(corner, 1.0);
    return place;
}

Vec3 extentOf(const Box3& bounds) { return bounds.empty() ? Vec3(0.0) : 2.0 * bounds.halfExtent(); }

/// The walls around a scene, in its own court.
std::array<Mat4, kWallsOfACourt> wallsAround(const Box3& bounds, const Axes& axes, double height) {
    const Vec3 extent = extentOf(bounds);
    const double longer = std::max(extent[axes.right], extent[axes.ahead]);
    const double gap = kGap * longer, thick = kThickness * longer;
    std::array<Mat4, kWallsOfACourt> walls;
    for (size_t i = 0; i < walls.size(); ++i) {
        const int across = i < 2 ? axes.right : axes.ahead, along = i < 2 ? axes.ahead : axes.right;
        Vec3 corner = bounds.min, size(0.0);
        size[across] = thick;
        // Two of them reach over the ends of the others and above them, so that the corners are closed and where they meet no
        // two visible surfaces lie in one plane.
        const double over = gap + (i < 2 ? 2.0 : 0.5) * thick;
        size[along] = extent[along] + 2.0 * over;
        size[axes.up] = height * extent[axes.up] + (i < 2 ? thick : 0.0);
        corner[along] -= over;
        corner[across] = i % 2 == 0 ? bounds.min[across] - gap - thick : bounds.max[across] + gap;
        walls[i] = placed(corner, size);
    }
    return walls;
}

bool hasWalls(const Scene& one, const Courts& courts) {
    return courts.walls > 0.0 && extentOf(one.bounds())[Axes(one.upAxis()).up] > 0.0;
}

/// What of a scene's remarks holds for its copies too; `meshes`: how many there are, with the wall.
SceneRemarks remarksOfCopies(const Scene& one, size_t meshes) {
    SceneRemarks remarks;
    remarks.camera = one.remarks().camera;
    remarks.up = one.remarks().up;
    // The guess is from the extent, which several courts change.
    remarks.guessedUp = one.upAxis();
    remarks.components = one.remarks().components;
    if (remarks.components && meshes > one.meshes().size()) {
        // A wall is of no primitive.
        Components components = *remarks.components;
        components.firstPart.push_back(components.firstPart.back());
        remarks.components = std::make_shared<const Components>(std::move(components));
    }
    return remarks;
}

}  // namespace

size_t objectsOfACourt(const Scene& one, const Courts& courts) {
    return one.instances().size() + (hasWalls(one, courts) ? kWallsOfACourt : 0);
}

ScenePointer courtsScene(std::string name, const Scene& one, const Courts& courts, const Progress& progress) {
    const Axes axes(one.upAxis());
    std::vector<MeshPointer> meshes = one.meshes();
    std::vector<Instance> court = one.instances();
    if (hasWalls(one, courts)) {
        const auto wall = static_cast<uint32_t>(meshes.size());
        meshes.push_back(cube());
        const auto walls = wallsAround(one.bounds(), axes, courts.walls);
        for (size_t i = 0; i < walls.size(); ++i) court.push_back({wall, walls[i], "wall " + std::to_string(i + 1)});
    }
    const Vec3 extent = extentOf(one.bounds());
    const double beside = (2.0 * (kGap + 2.0 * kThickness) + kAlley) * std::max(extent[axes.right], extent[axes.ahead]);
    std::vector<Instance> instances;
    instances.reserve(court.size() * courts.n * courts.n);
    instances = court;
    const auto middle = int64_t(courts.n) / 2;
    for (int64_t i = -middle; i < int64_t(courts.n) - middle; ++i)
        for (int64_t j = -middle; j < int64_t(courts.n) - middle; ++j) {
            progress.check();
            if (i == 0 && j == 0) continue;
            Vec3 away(0.0);
            away[axes.right] = double(i) * (extent[axes.right] + beside);
            away[axes.ahead] = double(j) * (extent[axes.ahead] + beside);
            const std::string place = " " + std::to_string(i) + "," + std::to_string(j);
            for (const Instance& object : court) {
                Instance copy = object;
                copy.worldFromMesh[3] += Vec4(away, 0.0);
                copy.name += place;
                instances.push_back(std::move(copy));
            }
        }
    SceneRemarks remarks = remarksOfCopies(one, meshes.size());
    return std::make_shared<const Scene>(std::move(name), std::move(meshes), std::move(instances), nullptr, std::move(remarks));
}

ScenePointer firstCourt(const Scene& courts, size_t n) {
    const auto count = std::ptrdiff_t(courts.instances().size() / (n * n));
    std::vector<Instance> instances(courts.instances().begin(), courts.instances().begin() + count);
    return std::make_shared<const Scene>(courts.name(), courts.meshes(), std::move(instances), nullptr, courts.remarks());
}

}  // namespace cullscope
