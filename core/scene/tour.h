#pragma once

#include "core/base/progress.h"
#include "core/scene/camera_path.h"

namespace cullscope {

/// Whether one stands in a scene to see it, as in a building, a courtyard or a city: most of its extent seen from above has a
/// floor, and on most of that something around rises above it. False, and not computed, above kOptionalAnalysisLimit triangles.
[[nodiscard]] bool isStoodIn(const Scene& scene);

/// Poses of a visitor who stands in a scene (docs/command-line.md, "Camera paths"): above a floor, outside solids, no surface
/// nearer than a part of the height above the floor; looking where many objects are to be seen, different ones from pose to pose,
/// and where no flat surface and no object fills the picture. Ordered as a walk from place to place. The same for the same scene,
/// however many threads there are. Where a scene has no such place, the poses are those of `orbit:N`. Costs SceneRays and some
/// hundred thousand rays. Throws Error(Interrupted) on a stop request.
[[nodiscard]] CameraPath tour(const Scene& scene, size_t count, const Progress& progress = {});

}  // namespace cullscope
