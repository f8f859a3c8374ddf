#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// The largest number of meshes made by a split: each one costs buffers, bounds and a draw call of its own.
inline constexpr size_t kMostParts = 100'000;

/// The connected components of a mesh: triangles are connected where corners have the same position, also where their indices
/// differ. Largest first, components of equal size by their first triangle. Throws Error(Usage) above kMostParts,
/// Error(Interrupted) on a stop request.
///
/// Every part keeps the mesh's origin, exact positions, normals and the order of its triangles, so that the parts together draw
/// the mesh's picture; only where two parts have equal depth may another triangle be visible. A mesh that has only one part is
/// returned itself. Named after the mesh with a number from 1. Runs on one thread; the result is the same on every machine.
[[nodiscard]] std::vector<MeshPointer> components(const MeshPointer& mesh, const Progress& progress = {});

/// The mesh cut into spatially compact clusters of at most `most` triangles (at least 1), the fewest possible: the triangles'
/// centroids are halved repeatedly along the longest axis of their box. The parts have the properties above, in the order of the
/// halving. Throws as above.
[[nodiscard]] std::vector<MeshPointer> clusters(const MeshPointer& mesh, size_t most, const Progress& progress = {});

}  // namespace cullscope
