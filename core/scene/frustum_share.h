#pragma once

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The number of a scene's triangles that have a point in the view's frustum, back faces included: each is clipped against the
/// six planes in double. With `step` above 1 only every step-th triangle of the scene is tested, and the number is of those.
[[nodiscard]] uint64_t trianglesInFrustum(const Scene& scene, const View& view, uint64_t step = 1);

}  // namespace cullscope
