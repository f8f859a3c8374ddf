#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/geometry/bounds.h"

namespace cullscope {

/// Properties of a mesh's surface that follow from its edges; corners at the same position count as one vertex.
struct Topology {
    size_t boundaryEdges = 0;      ///< edges with one triangle
    size_t nonManifoldEdges = 0;   ///< edges with more than two triangles
    size_t inconsistentEdges = 0;  ///< edges that two triangles traverse in the same direction
    bool closed = false;           ///< no boundary edge and no non-manifold edge
    bool consistentlyOriented = false;
    bool outward = false;  ///< whether the signed volume is positive (meaningful for closed meshes)

    /// Whether no back face can be visible from outside, unless the mesh has pockets that are inside out (TriangleMesh::pockets),
    /// which are not looked for here: the criterion of `facing = auto`.
    [[nodiscard]] bool frontFacesSuffice() const { return closed && consistentlyOriented && outward; }
};

/// Whether parts of a closed mesh are inside out: their winding number is negative, as in folds that cross the rest of the mesh,
/// or in a turned-over box beside others. A back face is seen where one is seen from outside.
enum class Pockets {
    None,
    Found,
    NotProven  ///< the mesh is not closed or not consistently oriented, or rounding left it open
};

/// Above this many triangles, analyses that the user did not request (closedness, ground truth in the desktop) are skipped.
inline constexpr size_t kOptionalAnalysisLimit = 5'000'000;

/// Triangles as flat arrays: float positions relative to a double origin, one normal for each vertex, three indices for each
/// triangle. Immutable; expensive properties are computed at the first call.
class TriangleMesh {
public:
    struct Data {
        std::string name;
        Vec3 origin{0.0};               ///< world position of the origin of the float coordinates
        std::vector<Vec3f> positions;   ///< relative to `origin`, finite
        std::vector<Vec3f> normals;     ///< unit length, one for each position; empty: computed by the constructor
        std::vector<uint32_t> indices;  ///< three for each triangle, each below positions.size()
    };

    /// Takes the arrays; asserts their invariants. Missing normals are computed (area-weighted).
    explicit TriangleMesh(Data data);
    TriangleMesh(const TriangleMesh&) = delete;
    TriangleMesh& operator=(const TriangleMesh&) = delete;

    [[nodiscard]] const std::string& name() const { return m_data.name; }
    [[nodiscard]] const Vec3& origin() const { return m_data.origin; }
    [[nodiscard]] std::span<const Vec3f> positions() const { return m_data.positions; }
    [[nodiscard]] std::span<const Vec3f> normals() const { return m_data.normals; }
    [[nodiscard]] std::span<const uint32_t> indices() const { return m_data.indices; }
    [[nodiscard]] size_t vertexCount() const { return m_data.positions.size(); }
    [[nodiscard]] size_t triangleCount() const { return m_data.indices.size() / 3; }
    [[nodiscard]] Vec3 position(size_t vertex) const { return m_data.origin + Vec3(m_data.positions[vertex]); }

    /// Bounds of the float positions relative to `origin()`, of the vertices that a triangle uses.
    [[nodiscard]] const Box3& localBounds() const { return m_localBounds; }
    /// A sphere around the float positions, relative to `origin()`; computed at the first call.
    [[nodiscard]] const Sphere& localSphere() const;
    /// Computed at the first call: O(triangles · log triangles), about 0.3 s and 24 bytes for each edge, for a million triangles.
    [[nodiscard]] const Topology& topology() const;
    /// Looked for at the first call: about 1 s for a million triangles, in parallel. Throws Error(Interrupted) on a stop request;
    /// the next call then looks again.
    [[nodiscard]] Pockets pockets(const Progress& progress = {}) const;
    /// Size of the arrays in bytes.
    [[nodiscard]] size_t bytes() const;

private:
    Data m_data;
    Box3 m_localBounds;
    mutable std::once_flag m_sphereOnce;
    mutable Sphere m_sphere;
    mutable std::once_flag m_topologyOnce;
    mutable Topology m_topology;
    mutable std::once_flag m_pocketsOnce;
    mutable Pockets m_pockets = Pockets::NotProven;
};

using MeshPointer = std::shared_ptr<const TriangleMesh>;

}  // namespace cullscope
