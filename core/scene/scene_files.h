#pragma once

#include <string>
#include <vector>

namespace cullscope {

/// Extensions of all files that openScene (scene_source.h) reads, lower case without a dot: meshes, polygons, plants.
[[nodiscard]] const std::vector<std::string>& readableSceneExtensions();

}  // namespace cullscope
