#pragma once

#include <string_view>

#include "core/scene/camera_path.h"

namespace cullscope {

/// cameraPath(nameOrFile, scene) where one of its poses alone is needed: those of a paper's case are each searched for among all
/// triangles, and here the others are not. Throws what cameraPath throws.
[[nodiscard]] CameraPath cameraPathAt(std::string_view nameOrFile, size_t pose, const Scene& scene);

}  // namespace cullscope
