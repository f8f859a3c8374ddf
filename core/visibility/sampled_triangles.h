#pragma once

#include <span>
#include <vector>

#include "core/frame/decision.h"
#include "core/frame/draw_list.h"
#include "core/geometry/frustum_batch.h"
#include "core/scene/camera.h"
#include "core/visibility/left_out_triangles.h"
#include "core/visibility/sampled_triangles_kernel.h"

namespace cullscope {

/// The corners of a mesh's triangles in some order, as the tests of single triangles read them: 36 bytes a triangle.
class CornerBlocks {
public:
    CornerBlocks() = default;
    /// `indices`: three for each triangle, in the order that places refer to.
    CornerBlocks(const TriangleMesh& mesh, std::span<const uint32_t> indices);

    [[nodiscard]] std::span<const CornerBlock> blocks() const { return m_blocks; }
    /// By axis the largest absolute value of a coordinate, relative to the mesh's origin.
    [[nodiscard]] const Vec3& reach() const { return m_reach; }
    [[nodiscard]] uint64_t bytes() const { return m_blocks.size() * sizeof(CornerBlock); }

private:
    std::vector<CornerBlock> m_blocks;
    Vec3 m_reach{0.0};
};

/// Finds the triangles of an object that certainly show nothing in a view's picture: those that hold no pixel centre and, where
/// front faces alone are drawn, those that face away. Conservative: a corner may lie anywhere within what OpenGL's float rounding
/// and snapping to 1/256 pixel may move it by. Nothing is said of a triangle that OpenGL may clip at the near plane, far plane or
/// beyond the picture, where it rounds anew.
class SampledTriangles {
public:
    /// `corners`: of the instance's mesh. `facing`: the rule of the frame.
    SampledTriangles(const Scene& scene, uint32_t instance, const CornerBlocks& corners, const View& view, Facing facing,
                     SimdLevel level = bestSimdLevel());

    /// The triangles of some places that may show something, and the number of the others.
    struct Found {
        std::vector<PlaceRun> kept;  ///< ascending
        uint64_t facingAway = 0, withoutSample = 0;
        std::vector<LeftOutTriangles::Run> leftOut{};  ///< the others, where they are asked for
    };
    /// Of disjoint runs of places, ascending; on every core. `others`: those that are left out are asked for.
    [[nodiscard]] Found among(std::span<const PlaceRun> runs, bool others = false) const;
    /// The share that would be left out of those runs, those that face away counted by `weightOfAway`: of one in 32 triangles,
    /// spread over all of them.
    [[nodiscard]] double estimatedShare(std::span<const PlaceRun> runs, double weightOfAway) const;

private:
    /// Adds what is found among the places of a run.
    void add(const PlaceRun& places, bool others, Found& found) const;

    const CornerBlocks& m_corners;
    SampleTest m_test;
    void (*m_kernel)(std::span<const CornerBlock>, const SampleTest&, BlockVerdict*);
};

}  // namespace cullscope
