#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// Edges of a triangle mesh by how many triangles share them; corners at the same position count as one vertex.
struct EdgeCounts {
    size_t boundary = 0;      ///< edges with one triangle
    size_t nonManifold = 0;   ///< edges with more than two triangles
    size_t inconsistent = 0;  ///< edges that two triangles traverse in the same direction
};

/// Counts the edges of triangles. Triangles with two corners at one position have no area and are skipped. Needs fewer than 2^31
/// positions. Throws Error(Interrupted) on a stop request.
[[nodiscard]] EdgeCounts countEdges(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                    const Progress& progress);

/// For each triangle the first one that it is connected with over edges, by the same vertices; a triangle that was skipped is
/// connected with itself. Throws as above.
[[nodiscard]] std::vector<uint32_t> edgeComponents(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                                   const Progress& progress);

}  // namespace cullscope
