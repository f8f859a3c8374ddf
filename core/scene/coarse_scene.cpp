#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/coarse_mesh.h"

namespace cullscope {

namespace {

/// With fewer triangles an object with long thin parts is not recognised.
constexpr double kFewest = 48.0;
constexpr uint64_t kMostMerged = 4'000'000;
constexpr size_t kLooks = 1024;  ///< a stop request is looked at once for so many objects

}  // namespace

ScenePointer coarseScene(const Scene& scene, uint64_t triangles, const Progress& progress) {
    const double share = double(triangles) / double(std::max<uint64_t>(1, scene.triangleCount()));
    const std::vector<bool> shown = scene.shownMeshes();
    std::vector<MeshPointer> meshes;
    meshes.reserve(shown.size());
    for (size_t number = 0; number < shown.size(); ++number) {
        progress.check();
        const MeshPointer& mesh = scene.meshes()[number];
        const double wanted = std::max(kFewest, std::floor(share * double(mesh->triangleCount())));
        meshes.push_back(shown[number] ? coarseMesh(mesh, size_t(wanted)) : mesh);
    }
    return std::make_shared<const Scene>(scene.name(), std::move(meshes), scene.instances());
}

ScenePointer mergedScene(const Scene& scene, const Progress& progress) {
    progress.check();
    if (scene.triangleCount() > kMostMerged) return nullptr;
    TriangleMesh::Data data;
    data.name = scene.name();
    data.origin = scene.bounds().empty() ? Vec3(0.0) : 0.5 * (scene.bounds().min + scene.bounds().max);
    data.indices.reserve(3 * scene.triangleCount());
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        if (i % kLooks == 0) progress.check();
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat4& worldFromMesh = scene.instances()[i].worldFromMesh;
        const auto turned = glm::transpose(glm::inverse(glm::dmat3(worldFromMesh)));
        const auto first = uint32_t(data.positions.size());
        for (size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
            data.positions.emplace_back(Vec3(worldFromMesh * Vec4(mesh.position(vertex), 1.0)) - data.origin);
            const Vec3 normal = turned * Vec3(mesh.normals()[vertex]);
            const double length = glm::length(normal);
            // A flattened object has none: any direction will do.
            data.normals.push_back(length > 0.0 && std::isfinite(length) ? Vec3f(normal / length) : mesh.normals()[vertex]);
        }
        for (const uint32_t index : mesh.indices()) data.indices.push_back(first + index);
    }
    auto mesh = std::make_shared<const TriangleMesh>(std::move(data));
    return std::make_shared<const Scene>(scene.name(), std::vector<MeshPointer>{mesh}, std::vector<Instance>{{}});
}

}  // namespace cullscope
