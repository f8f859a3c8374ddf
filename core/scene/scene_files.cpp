#include "core/scene/scene_files.h"

#include "core/mesh/byte_source.h"
#include "core/mesh/mesh_assembler.h"
#include "core/scene/gltf/gltf_scene.h"
#include "core/scene/ifc/ifc_scene.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/quake/quake_scene.h"
#include "core/scene/rvm/rvm_scene.h"

namespace cullscope {

std::string contentOf(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    ByteSource source(path, progress, false, options.memoryLimitBytes);
    MeshAssembler(source.name(), options, progress).requireMemory(2 * source.size());
    return source.rest();
}

const std::vector<std::string>& readableSceneExtensions() {
    static const std::vector<std::string> extensions = [] {
        std::vector<std::string> all = readableMeshExtensions();
        all.insert(all.end(), {kPolygonExtension, kRvmExtension, kQuakeExtension, kIfcExtension});
        all.insert(all.end(), kGltfExtensions.begin(), kGltfExtensions.end());
        return all;
    }();
    return extensions;
}

}  // namespace cullscope
