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

/// What a file contains, unpacked. Throws Error(Input) where it cannot be read, or twice its size is more memory than `options`
/// allow.
[[nodiscard]] std::string contentOf(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress);

/// Extensions of all files that openScene (scene_source.h) reads, lower case without a dot: meshes, polygons, plants, levels,
/// glTF, buildings.
[[nodiscard]] const std::vector<std::string>& readableSceneExtensions();

}  // namespace cullscope
