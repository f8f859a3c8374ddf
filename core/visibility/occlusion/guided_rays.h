#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/random.h"
#include "core/scene/scene_rays.h"

namespace cullscope::occlusion {

/// Finds the objects that are visible from a cell by rays that follow what was found: guided visibility sampling (Wonka, Wimmer,
/// Zhou, Maierhofer, Hesina & Reshetov 2006). What a ray meets is visible; what no ray met may be visible all the same.
///
/// A third of the rays goes in random directions, a third to random points of objects that were not seen yet, and a third around
/// triangles that were seen for the first time:
///  - adaptive border sampling: rays from the same place past the triangle's corners and edges, a little outside of it, meet its
///    neighbours;
///  - reverse sampling: where such a ray ends before it comes to the triangle's border, that place is looked at from another
///    point of the cell, past the edge of what was in the way.
class GuidedRays {
public:
    struct Options {
        uint64_t rays = 0;  ///< for a cell
        uint64_t seed = 0;
    };

    /// Scene and rays must outlive this object.
    GuidedRays(const Scene& scene, const SceneRays& rays) : m_scene(scene), m_rays(rays) {}

    /// What one thread remembers from cell to cell.
    struct Work {
        std::vector<uint32_t> metIn;  ///< by triangle of the scene: the last cell, counted from 1, from which it was met
        uint32_t cell = 0;
    };
    /// Marks in `seen` (a byte for each object) what rays from the cell meet. Returns how many rays there were: fewer than asked
    /// for where everything is seen. Throws Error(Interrupted) soon after a stop is requested.
    [[nodiscard]] uint64_t sample(const Box3& cell, const Options& options, Work& work, std::vector<uint8_t>& seen,
                                  const Progress& progress = {}) const;

private:
    class OfCell;

    const Scene& m_scene;
    const SceneRays& m_rays;
};

}  // namespace cullscope::occlusion
