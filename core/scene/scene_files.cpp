#include "core/scene/scene_files.h"

#include "core/mesh/load.h"
#include "core/scene/gltf/gltf_scene.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/quake/quake_scene.h"
#include "core/scene/rvm/rvm_scene.h"

namespace cullscope {

const std::vector<std::string>& readableSceneExtensions() {
    static const std::vector<std::string> extensions = [] {
        std::vector<std::string> all = readableMeshExtensions();
        all.insert(all.end(), {kPolygonExtension, kRvmExtension, kQuakeExtension});
        all.insert(all.end(), kGltfExtensions.begin(), kGltfExtensions.end());
        return all;
    }();
    return extensions;
}

}  // namespace cullscope
