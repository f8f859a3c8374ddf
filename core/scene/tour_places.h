#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene_rays.h"

namespace cullscope {

/// A place at which one can stand.
struct TourPlace {
    Vec3 eye;
    double aboveFloor = 0.0;  ///< scene units
    double backs = 0.0;       ///< the share of back faces among what is seen in all directions
};

/// At most `count` places above floors, spread over the scene, in an order that is random but always the same. No surface is
/// nearer to one than a part of its height above the floor. Places that see more back faces than most others are left out: they
/// lie behind walls that have one side.
[[nodiscard]] std::vector<TourPlace> tourPlaces(const Scene& scene, const SceneRays& rays, size_t count,
                                                const Progress& progress);

/// Whether a point lies inside a closed, consistently oriented mesh: its winding number, the sum of solid angles, is not 0.
[[nodiscard]] bool insideSolid(const Scene& scene, const Vec3& point);

}  // namespace cullscope
