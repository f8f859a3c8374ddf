#pragma once

#include <string>
#include <vector>

#include "core/mesh/load.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What the reader of one format gives.
struct FileScene {
    ScenePointer scene;
    LoadReport report;
};

/// Extensions of all files that openScene (scene_source.h) reads, lower case without a dot: meshes, polygons, plants, levels,
/// glTF.
[[nodiscard]] const std::vector<std::string>& readableSceneExtensions();

}  // namespace cullscope
