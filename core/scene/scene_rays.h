#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Rays through a scene's triangles: Embree in robust mode (Woop et al. 2013). Shares no code with the GPU path. Costs a tree
/// over all instances' triangles: about 1 s and 150 bytes a triangle for a million triangles. The scene must outlive this object.
class SceneRays {
public:
    struct Hit {
        uint32_t instance = 0;
        uint32_t triangle = 0;  ///< its number in the mesh
        double distance = 0.0;  ///< in lengths of the ray's direction
    };

    /// Embree has floats, here relative to `origin`: rays are the more exact, the nearer to it they begin. Back faces of the
    /// instances that `frontOnly` names let rays pass; empty: every face stops them. Throws Error(Interrupted) on a stop request.
    SceneRays(const Scene& scene, const Vec3& origin, const std::function<bool(uint32_t)>& frontOnly = {},
              const Progress& progress = {});
    ~SceneRays();
    SceneRays(const SceneRays&) = delete;
    SceneRays& operator=(const SceneRays&) = delete;

    /// The first triangle from a point along a direction of any length but 0, between two distances. Of triangles at the same
    /// distance it may be any one.
    [[nodiscard]] std::optional<Hit> first(const Vec3& from, const Vec3& direction, double nearest = 0.0,
                                           double farthest = std::numeric_limits<double>::infinity()) const;
    /// The same, and of triangles at nearly the same distance the one with the smallest number: it does not depend on how the
    /// tree was built.
    [[nodiscard]] std::optional<Hit> firstByNumber(const Vec3& from, const Vec3& direction) const;
    /// The distance from a point to the nearest surface, both of its sides counting; infinity where there is none.
    [[nodiscard]] double clearance(const Vec3& point) const;

private:
    struct Tree;
    std::unique_ptr<const Tree> m_tree;
};

}  // namespace cullscope
