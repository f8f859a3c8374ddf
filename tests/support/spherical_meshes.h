#pragma once

#include <array>
#include <vector>

#include "core/geometry/random.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope::test {

/// A mesh of unconnected triangles.
[[nodiscard]] MeshPointer looseTriangles(const std::vector<std::array<Vec3f, 3>>& triangles);

/// Triangles that are difficult for a map of angles: over a pole, with a corner or an edge on it, across the seam, in a plane
/// through the centre, around it, with a corner at it, needles and points.
[[nodiscard]] MeshPointer awkwardTriangles();

/// Random triangles of all sizes and shapes around the centre, by seed.
[[nodiscard]] MeshPointer randomTriangles(uint64_t seed, size_t count);

/// The meshes with which the maps are tested: generated ones, the difficult ones, and real ones where their files are installed.
[[nodiscard]] std::vector<MeshPointer> mapTestMeshes();

}  // namespace cullscope::test
