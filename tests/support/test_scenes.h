#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/scene/scene.h"
#include "tests/support/long_mode.h"

namespace cullscope::test {

/// A mesh from positions and indices, its float coordinates about `origin`.
inline MeshPointer meshOf(std::vector<Vec3f> positions, std::vector<uint32_t> indices, const Vec3& origin = Vec3(0.0)) {
    TriangleMesh::Data data;
    data.name = "test";
    data.origin = origin;
    data.positions = std::move(positions);
    data.indices = std::move(indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// A closed box of twelve triangles that face outward.
inline MeshPointer boxMesh(const Vec3f& min, const Vec3f& max, const Vec3& origin = Vec3(0.0)) {
    std::vector<Vec3f> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners.emplace_back((corner & 1) != 0 ? max.x : min.x, (corner & 2) != 0 ? max.y : min.y,
                             (corner & 4) != 0 ? max.z : min.z);
    return meshOf(std::move(corners), {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,  //
                                       2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6},
                  origin);
}

/// A square of two triangles at height z, facing +z.
inline MeshPointer squareMesh(float half, float z) {
    return meshOf({{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}, {0, 1, 2, 0, 2, 3});
}

/// The same mesh with its float coordinates relative to another origin.
inline MeshPointer withOrigin(const TriangleMesh& mesh, const Vec3& origin) {
    TriangleMesh::Data data;
    data.name = mesh.name();
    data.origin = origin;
    data.positions.assign(mesh.positions().begin(), mesh.positions().end());
    data.normals.assign(mesh.normals().begin(), mesh.normals().end());
    data.indices.assign(mesh.indices().begin(), mesh.indices().end());
    return std::make_shared<TriangleMesh>(std::move(data));
}

inline Mat4 translation(const Vec3& by) {
    Mat4 matrix(1.0);
    matrix[3] = Vec4(by, 1.0);
    return matrix;
}

inline Mat4 scaling(const Vec3& by) {
    Mat4 matrix(1.0);
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = by[axis];
    return matrix;
}

/// A scene of meshes, one instance each, with these transforms (identity where there are fewer).
inline ScenePointer sceneOf(std::vector<MeshPointer> meshes, const std::vector<Mat4>& places = {}) {
    std::vector<Instance> instances;
    for (uint32_t i = 0; i < meshes.size(); ++i)
        instances.push_back({i, i < places.size() ? places[i] : Mat4(1.0), "object " + std::to_string(i)});
    return std::make_shared<Scene>("test", std::move(meshes), std::move(instances));
}

/// A scene of one mesh, an instance for every transform.
inline ScenePointer copiesOf(MeshPointer mesh, const std::vector<Mat4>& places) {
    std::vector<Instance> instances;
    for (const Mat4& place : places) instances.push_back({0, place, "copy " + std::to_string(instances.size())});
    return std::make_shared<Scene>("test", std::vector<MeshPointer>{std::move(mesh)}, std::move(instances));
}

}  // namespace cullscope::test
