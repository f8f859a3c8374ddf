// Scenes of the gallery: solids, and what maps of directions are hard pressed by.
#include <array>
#include <cmath>

#include "core/mesh/parametric.h"
#include "core/scene/gallery/gallery_parts.h"

namespace cullscope::gallery {
namespace {

constexpr size_t kSolid = 6'000;  // triangles: enough for a few in each cell of a map, few enough for every strategy

}  // namespace

Parts& Parts::add(MeshPointer mesh, const Mat4& place) {
    instances.push_back({uint32_t(meshes.size()), place, mesh->name()});
    meshes.push_back(std::move(mesh));
    return *this;
}

Parts& Parts::copy(const Mat4& place) {
    instances.push_back({uint32_t(meshes.size() - 1), place, meshes.back()->name()});
    return *this;
}

Parts& Parts::from(const Camera& camera) {
    cameras.push_back(camera);
    return *this;
}

Parts& Parts::from(const std::vector<Camera>& all) {
    cameras.insert(cameras.end(), all.begin(), all.end());
    return *this;
}

Mat4 moved(const Vec3& by) {
    Mat4 matrix(1.0);
    matrix[3] = Vec4(by, 1.0);
    return matrix;
}

Mat4 scaled(const Vec3& by) {
    Mat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = by[axis];
    return matrix;
}

Mat4 turned(const Vec3& axis, double radians) {
    const Vec3 a = glm::normalize(axis);
    Mat4 matrix(1.0);
    for (int column = 0; column < 3; ++column) {
        Vec3 unit(0.0);
        unit[column] = 1.0;
        const Vec3 image = std::cos(radians) * unit + std::sin(radians) * glm::cross(a, unit) +
                           (1.0 - std::cos(radians)) * glm::dot(a, unit) * a;
        matrix[column] = Vec4(image, 0.0);
    }
    return matrix;
}

MeshPointer meshOf(std::vector<Vec3f> positions, std::vector<uint32_t> indices, const Vec3& origin) {
    TriangleMesh::Data data;
    data.name = "part";
    data.origin = origin;
    data.positions = std::move(positions);
    data.indices = std::move(indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

MeshPointer soup(std::vector<Vec3f> corners) {
    std::vector<uint32_t> indices(corners.size());
    for (uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    return meshOf(std::move(corners), std::move(indices));
}

MeshPointer box(const Vec3& min, const Vec3& max) {
    std::vector<Vec3f> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.emplace_back(
            Vec3((corner & 1) != 0 ? max.x : min.x, (corner & 2) != 0 ? max.y : min.y, (corner & 4) != 0 ? max.z : min.z));
    return meshOf(std::move(corners), {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,  //
                                       2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6});
}

MeshPointer square(float half, float z) {
    return meshOf({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, {0, 1, 2, 0, 2, 3});
}

Camera usualCamera() { return {Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 10}; }

Camera cameraAt(const Vec3& eye, double fovyDegrees, const Vec3& target, double far) {
    return {eye, target, {0.01, 1, 0.1}, Angle::fromDegrees(fovyDegrees), 0.05, far};
}

Parts sphereBesideTheCorner() {
    return Parts().add(sphereMesh(320), moved({13, 13, -11}) * scaled(Vec3(1.5))).from(usualCamera());
}

Parts boxBesideTheCorner() { return Parts().add(box({15, -5, -30}, {40, 5, -9.5})).from(usualCamera()); }

Parts cornersAtTheCentre() {
    // The bounding sphere is that of the first triangle; the second has a corner at its centre, the third its centroid.
    return Parts()
        .add(meshOf({{1, 0, 0},
                     {-1, 0, 0},
                     {0, 1, 0},
                     {0, 0, 0},
                     {0.5f, 0, 0},
                     {0, 0.5f, 0},
                     {0.25f, 0, 0},
                     {-0.125f, 0.25f, 0},
                     {-0.125f, -0.25f, 0}},
                    {0, 1, 2, 3, 4, 5, 6, 7, 8}))
        .from({cameraAt({0, 0, 3}, 45), cameraAt({1.2, 0.4, 2}, 45), cameraAt({0.4, -1.4, -2}, 45)});
}

Parts latitudes() {
    Parts parts = Parts().add(sphereMesh(kSolid));
    for (const double degrees : {0.0, 45.0, 60.0, 75.0, 90.0}) {
        const double latitude = Angle::fromDegrees(degrees).radians();
        parts.from(cameraAt(3.0 * Vec3(std::cos(latitude), 0.0, std::sin(latitude)), 20));
    }
    return parts;
}

Parts pole() { return Parts().add(sphereMesh(kSolid)).from({cameraAt({0, 0, 3}, 20), cameraAt({0, 0, -3}, 20)}); }

Parts missedByCornerRays() {
    Camera camera = usualCamera();
    camera.farDistance = 100;
    return Parts().add(sphereMesh(kSolid), moved({11, 0, -10}) * scaled(Vec3(2.0))).from(camera);
}

Parts ballInItsSphere() {
    // A ball of radius 0.5, and two distant triangles that give the bounding sphere a radius of 1.
    const MeshPointer ball = sphereMesh(kSolid);
    std::vector<Vec3f> positions;
    for (const Vec3f& position : ball->positions()) positions.push_back(0.5f * position);
    std::vector<uint32_t> indices(ball->indices().begin(), ball->indices().end());
    for (const float side : {1.0f, -1.0f}) {
        const auto base = uint32_t(positions.size());
        for (const Vec3f& corner : {Vec3f(0, 0, side), Vec3f(0.001f, 0, 0.999f * side), Vec3f(0, 0.001f, 0.999f * side)})
            positions.push_back(corner);
        for (uint32_t i = 0; i < 3; ++i) indices.push_back(base + i);
    }
    return Parts()
        .add(meshOf(std::move(positions), std::move(indices)))
        .from({cameraAt({-3, 0.45, 0}, 30, {0, 0.45, 0}), cameraAt({0.5, -3, 0.5}, 30)});
}

Parts torus() {
    return Parts().add(torusMesh(kSolid), turned({1, 0, 0}, Angle::fromDegrees(30).radians())).from(cameraAt({0, 0, 40}, 6));
}

Parts bowl() { return Parts().add(bowlMesh(kSolid)).from(cameraAt({0, 0, 6}, 25)); }

Parts insideAStar() {
    Parts parts = Parts().add(starMesh(5, kSolid));
    // At the centre of the bounding sphere to the last bit.
    const Vec3 centre = Scene("", parts.meshes, parts.instances).instanceSphere(0).centre;
    return parts.from({cameraAt({0.3, 0.2, 0.1}, 90, {1, 1, 1}), cameraAt(centre, 90, centre - Vec3(0, 0, 1))});
}

Parts narrowField() { return Parts().add(starMesh(7, kSolid)).from(cameraAt({0, 0, 5000}, 0.01, Vec3(0.0), 1e5)); }
Parts wideField() {
    // What lies ahead is smaller than a pixel, what lies at the side is large.
    Parts parts = Parts().add(starMesh(7, 2000), moved({0, 0, -3}));
    for (int i = 0; i < 12; ++i) {
        const double turn = kTurn * i / 12;
        parts.copy(moved({3.0 * std::cos(turn), 3.0 * std::sin(turn), 0.3 * (i % 3) - 0.8}) * scaled(Vec3(0.8)));
    }
    return parts.from({cameraAt(Vec3(0.0), 179, {0, 0, -1}), cameraAt({0.5, -0.5, 0.2}, 179, {0.6, -0.2, -1})});
}

Parts mirrored() {
    return Parts()
        .add(starMesh(8, kSolid), moved({-1.5, 0, 0}) * scaled({-1, 1, 1}))
        .copy(moved({1.5, 0, 0}) * scaled({1, 1, 0.1}))
        .from({cameraAt({0, 0.5, 6}, 40), cameraAt({1, 5, 2}, 40), cameraAt({-2, -3, -5}, 40)});
}

Parts partlyInsideOut() {
    // A vertex of its own for each corner of the second box, and its triangles turned over.
    const MeshPointer outer = box({-1, -1, -1}, {1, 1, 1}), inner = box({0.3, -0.45, -0.4}, {1.7, 0.5, 0.55});
    std::vector<Vec3f> positions(outer->positions().begin(), outer->positions().end());
    std::vector<uint32_t> indices(outer->indices().begin(), outer->indices().end());
    for (size_t i = 0; i < inner->indices().size(); i += 3)
        for (const size_t corner : {i, i + 2, i + 1}) indices.push_back(uint32_t(positions.size()) + inner->indices()[corner]);
    positions.insert(positions.end(), inner->positions().begin(), inner->positions().end());
    return Parts()
        .add(meshOf(std::move(positions), std::move(indices)))
        .from({cameraAt({4, 2.5, 3}, 40), cameraAt({5, -1, -2}, 40), cameraAt({-4, 2, 3}, 40)});
}

}  // namespace cullscope::gallery
