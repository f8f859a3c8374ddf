#pragma once

#include <functional>
#include <vector>

#include "core/experiments/han_hong_views.h"

namespace cullscope::han_hong {

/// Of `tries` random views of an object, 320 × 240, those that are wanted, in their order; at most `most`. The eye lies 1.05 to
/// 4 radii from the bounding sphere's centre, in any direction, the target anywhere within the sphere, with any roll. All are
/// from one fixed seed.
[[nodiscard]] std::vector<FoundView> randomViews(const Scene& scene, const ConsideredFaces& considered, Angle field, size_t tries,
                                                 size_t most, const std::function<bool(const Considered& found)>& wanted);

/// Of `tries` random views those of a case whose considered faces are within 5 % of the case's share of the object's.
[[nodiscard]] std::vector<FoundView> randomViewsOfCase(const Scene& scene, const ConsideredFaces& considered,
                                                       const TableCase& wanted, Angle field, size_t tries, size_t most);

}  // namespace cullscope::han_hong
