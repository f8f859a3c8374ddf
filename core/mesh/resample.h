#pragma once

#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// `mesh` with `triangles` triangles, or the nearest count that can be reached: fewer by quadric decimation (Garland & Heckbert
/// 1997), more by Loop subdivision (Loop 1987) followed by decimation down to the count. Half-edges are used only inside this
/// function. Corners at equal positions are joined first, and normals are recomputed. A closed mesh has an even count, so an odd
/// `triangles` gives a count that differs by one. Throws Error(Usage) where the count cannot be reached within 0.1 % + 2 (for
/// example, a mesh that falls into parts), Error(Interrupted) on a stop request.
[[nodiscard]] MeshPointer resampled(const TriangleMesh& mesh, size_t triangles, const Progress& progress = {});

/// A level of detail of a mesh: fewer triangles between vertices of the mesh.
struct MeshLevel {
    std::vector<uint32_t> indices;  ///< three vertices of the mesh for each triangle
    /// No point of either surface lies farther than this from the other surface; in the mesh's unit. An upper bound, computed
    /// from the surfaces (surface_distance.h). 0 where it was not computed.
    double error = 0.0;
};

/// Levels of a mesh by quadric decimation, finest first, each with at most two thirds of the triangles of the one before, without
/// their errors. Collapses only remove vertices, so that a level is other triangles between the same vertices; at an edge of the
/// surface each corner has the vertex of its place whose normal is nearest to the triangle's. Ends where no collapse is possible
/// that folds no triangle, or at `fewest` triangles. Throws Error(Interrupted) on a stop request.
[[nodiscard]] std::vector<MeshLevel> quadricLevels(const TriangleMesh& mesh, size_t fewest, const Progress& progress = {});

}  // namespace cullscope
