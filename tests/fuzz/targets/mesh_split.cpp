#include "core/mesh/split.h"

#include "core/scene/split_scene.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

size_t trianglesOf(const std::vector<MeshPointer>& meshes) {
    size_t triangles = 0;
    for (const MeshPointer& mesh : meshes) triangles += mesh->triangleCount();
    return triangles;
}

}  // namespace

void mesh_split(std::string_view input) {
    Values values(input);
    const size_t most = 1 + values.below(32);
    const ScenePointer scene = sceneOf(values);
    if (!scene) return;
    for (const MeshPointer& mesh : scene->meshes()) {
        require(trianglesOf(components(mesh)) == mesh->triangleCount(), "components lose or double triangles");
        const std::vector<MeshPointer> parts = clusters(mesh, most);
        require(trianglesOf(parts) == mesh->triangleCount(), "clusters lose or double triangles");
        for (const MeshPointer& part : parts) require(part->triangleCount() <= most, "a cluster is too large");
    }
    for (const SplitRule::By by : {SplitRule::By::Components, SplitRule::By::Clusters}) {
        const ScenePointer split = splitScene(*scene, "split", {by, most});
        require(split->triangleCount() == scene->triangleCount(), "a split scene has another number of triangles");
        requireSound(*split);
    }
}

}  // namespace cullscope::fuzz
