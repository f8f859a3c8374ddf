#pragma once

#include <span>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/pixel_cover.h"

namespace cullscope::small_feature {

/// Leaves out the triangles of objects in whose bounding rectangles on the screen no pixel centre lies: they cover no pixel.
class SampledTriangles {
public:
    /// `cover`: of the same view.
    SampledTriangles(const Scene& scene, const View& view, const PixelCover& cover);

    /// Appends the ranges of objects one after the other, on every core. Returns by object how many triangles are left out.
    [[nodiscard]] std::vector<uint64_t> appendAll(std::span<const KeptObject> objects, std::vector<DrawRange>& ranges) const;

private:
    /// Appends the ranges of an object's other triangles, in the mesh's order, and returns how many triangles are left out. What
    /// lies between two ranges close to each other is drawn too: it costs less than a range. Kept are triangles that reach the
    /// near plane or far beyond the picture, where OpenGL clips them and rounds anew.
    uint64_t append(uint32_t instance, std::vector<DrawRange>& ranges) const;

    const Scene& m_scene;
    const View& m_view;
    const PixelCover& m_cover;
};

}  // namespace cullscope::small_feature
