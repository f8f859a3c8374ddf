#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// Into more meshes than this nothing is split: each one costs buffers, bounds and a draw call of its own.
inline constexpr size_t kMostParts = 100'000;

/// The connected components of a mesh: triangles that share a corner's position hang together, whatever their indices. Largest
/// first, among equals the one whose first triangle comes first. Throws Error(Usage) above kMostParts, Error(Interrupted) on
/// stop.
///
/// Every part keeps the mesh's origin, exact positions, normals and its triangles' order, so that the parts draw what the mesh
/// draws; only where two parts have the very same depth may another one come first. A mesh of one part is that part itself.
/// Named after the mesh with a number from 1. One thread; the same on every machine.
[[nodiscard]] std::vector<MeshPointer> components(const MeshPointer& mesh, const Progress& progress = {});

/// The mesh cut into spatially compact clusters of at most `most` triangles (at least 1), as few as that allows: the triangles'
/// centroids are halved along the longest axis of their box, again and again. The parts are as above, in the order of the
/// halving. Throws as above.
[[nodiscard]] std::vector<MeshPointer> clusters(const MeshPointer& mesh, size_t most, const Progress& progress = {});

}  // namespace cullscope
