#pragma once

#include <array>
#include <vector>

#include "core/geometry/random.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope::test {

/// A mesh of loose triangles.
[[nodiscard]] MeshPointer looseTriangles(const std::vector<std::array<Vec3f, 3>>& triangles);

/// Triangles that a map of angles gets wrong most easily: over a pole, with a corner or an edge on it, over the seam, in a plane
/// through the centre, around it, with a corner in it, needles and points.
[[nodiscard]] MeshPointer awkwardTriangles();

/// Seeded triangles of all sizes and shapes around the centre.
[[nodiscard]] MeshPointer randomTriangles(uint64_t seed, size_t count);

/// The meshes over which the maps are tested: generated ones, the awkward ones, and real ones where they are at hand.
[[nodiscard]] std::vector<MeshPointer> mapTestMeshes();

}  // namespace cullscope::test
