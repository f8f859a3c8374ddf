#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// A mesh's triangles in groups of neighbours.
struct Meshlets {
    std::vector<uint32_t> triangles;  ///< the mesh's triangles, each once, group after group
    std::vector<uint32_t> starts;     ///< by group the place of its first triangle, then the number of all triangles

    [[nodiscard]] size_t size() const { return starts.size() - 1; }
    [[nodiscard]] std::span<const uint32_t> of(size_t group) const {
        return std::span(triangles).subspan(starts[group], starts[group + 1] - starts[group]);
    }
};

/// The largest number of triangles that a meshlet may have.
inline constexpr uint32_t kMostInMeshlet = 512;

/// Cuts a mesh into connected groups of at most `most` triangles that lie close together and face alike, as far as that goes
/// (meshoptimizer's meshlets; corners at equal positions count as one vertex, of which a group has at most 255). Within a group
/// triangles are in vertex-cache order. That each triangle is in one group is verified, not believed: what the library should
/// leave out would form groups of its own. `most`: 4 to kMostInMeshlet. About 1 µs for each triangle. Throws Error(Interrupted)
/// on a stop request.
[[nodiscard]] Meshlets cutIntoMeshlets(const TriangleMesh& mesh, uint32_t most, const Progress& progress = {});

}  // namespace cullscope
