#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/frame/draw_list.h"
#include "core/mesh/resample.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The levels of detail of a scene's meshes: fewer triangles between the same vertices, so that they need indices alone. A mesh
/// that consists of primitives alone is made of the same primitives with fewer segments, whose corners are moved to the mesh's
/// nearest vertices; any other mesh is simplified by quadrics. Every level has at most two thirds of the triangles of the one
/// before, so that all of a mesh's levels have at most twice its triangles. Does not change.
class DetailLevels {
public:
    /// A mesh with fewer triangles than this has no other level.
    static constexpr size_t kFewest = 16;

    struct Level {
        uint32_t firstIndex = 0, indexCount = 0;  ///< in `order`
        double error = 0.0;                       ///< as MeshLevel::error
    };

    DetailLevels() = default;
    /// Throws Error(Interrupted) on a stop request.
    DetailLevels(const Scene& scene, const Progress& progress);

    /// The levels of a mesh, finest first, with growing errors; the first one is the mesh itself.
    [[nodiscard]] std::span<const Level> of(uint32_t mesh) const {
        return std::span(m_levels).subspan(m_firstLevel[mesh], m_firstLevel[mesh + 1] - m_firstLevel[mesh]);
    }
    /// In which the levels' ranges count: the mesh's own triangles, then those of its levels as stand-ins.
    [[nodiscard]] const TriangleOrderPointer& order() const { return m_order; }
    [[nodiscard]] size_t bytes() const { return m_bytes; }
    /// Levels of all meshes, the meshes themselves not counted; and how many meshes have such, by the way they were made.
    [[nodiscard]] size_t coarserLevels() const { return m_levels.size() - (m_firstLevel.size() - 1); }
    [[nodiscard]] size_t meshesBySegments() const { return m_bySegments; }
    [[nodiscard]] size_t meshesByQuadrics() const { return m_byQuadrics; }

private:
    std::vector<Level> m_levels;
    std::vector<size_t> m_firstLevel{0};  ///< by mesh; one element more
    TriangleOrderPointer m_order;
    size_t m_bytes = 0, m_bySegments = 0, m_byQuadrics = 0;
};

/// The levels of a mesh of primitives by fewer segments, finest first, without the mesh itself, with their errors: such that the
/// errors grow. None where a part is no primitive. For DetailLevels, and for tests.
[[nodiscard]] std::vector<MeshLevel> segmentLevels(const TriangleMesh& mesh, std::span<const MeshPart> parts,
                                                   const Progress& progress);
/// The same by quadrics.
[[nodiscard]] std::vector<MeshLevel> decimatedLevels(const TriangleMesh& mesh, const Progress& progress);

}  // namespace cullscope
