#include "core/scene/coarse_scene.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/coarse_mesh.h"

namespace cullscope {

namespace {

/// With fewer triangles an object with long thin parts is not recognised.
constexpr double kFewest = 48.0;

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

}  // namespace cullscope
