#pragma once

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// `mesh` with `triangles` triangles, or the nearest count that can be reached: fewer by quadric decimation (Garland & Heckbert
/// 1997), more by Loop subdivision (Loop 1987) followed by decimation down to the count. Half-edges are used only inside this
/// function. Corners at equal positions are joined first, and normals are recomputed. A closed mesh has an even count, so an odd
/// `triangles` gives a count that differs by one. Throws Error(Usage) where the count cannot be reached within 0.1 % + 2 (for
/// example, a mesh that falls into parts), Error(Interrupted) on a stop request.
[[nodiscard]] MeshPointer resampled(const TriangleMesh& mesh, size_t triangles, const Progress& progress = {});

}  // namespace cullscope
