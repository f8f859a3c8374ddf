#pragma once

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// A scene of about so many triangles in place of another one: the same objects in the same places, whose meshes are coarser
/// (mesh/coarse_mesh.h), each by the same share. Small meshes keep a few triangles, so that there may be more in all. For
/// pictures that may be coarse, and for nothing that is measured. Throws Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer coarseScene(const Scene& scene, uint64_t triangles, const Progress& progress = {});

/// The triangles of a scene in one mesh, in the order of their numbers: one call of OpenGL draws them, where a picture of many
/// small objects takes longer for its calls than for its triangles. Their places are rounded to floats about the scene's centre.
/// Null for more than four million triangles. Throws Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer mergedScene(const Scene& scene, const Progress& progress = {});

}  // namespace cullscope
