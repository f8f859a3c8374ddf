#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The largest triangles of a mesh, the largest first: an occluder that can be cut off after any of them. Each is one of the
/// mesh's own, with the same float positions: so an occluder covers no pixel that its mesh does not cover, and lies nowhere
/// before it. Triangles without an area are left out.
struct OccluderMesh {
    std::vector<Vec3f> positions;     ///< of the mesh, in the order in which the triangles use them
    std::vector<uint32_t> indices;    ///< three of each triangle, into `positions`
    std::vector<uint32_t> triangles;  ///< numbers in the mesh
    /// By triangle: the mean area of it and those before it, in squared units of the mesh; descending.
    std::vector<float> means;
    std::vector<uint32_t> vertices;  ///< by triangle: how many positions it and those before it use

    [[nodiscard]] size_t count() const { return triangles.size(); }
    /// How many of the largest triangles have at least this area each on average.
    [[nodiscard]] size_t countFrom(double area) const;
    [[nodiscard]] uint64_t bytes() const;
};

/// So many triangles an occluder has at most, where nothing else is asked for.
inline constexpr size_t kMostOccluderTriangles = 4096;

/// The occluder of a mesh, or of some triangles of it, by their numbers.
[[nodiscard]] OccluderMesh occluderMesh(const TriangleMesh& mesh, size_t most = kMostOccluderTriangles);
[[nodiscard]] OccluderMesh occluderMesh(const TriangleMesh& mesh, std::span<const uint32_t> triangles,
                                        size_t most = kMostOccluderTriangles);
/// By mesh of a scene; of meshes without an instance an empty one. Throws Error(Interrupted) soon after a stop is requested.
[[nodiscard]] std::vector<OccluderMesh> occluderMeshes(const Scene& scene, const Progress& progress = {});

}  // namespace cullscope
