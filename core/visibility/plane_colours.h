#pragma once

#include <array>
#include <cstdint>

#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// A colour for each plane of a frustum, for light and dark backgrounds (chosen by the background's luminance). They can be
/// distinguished from each other, from the background and from the verdicts' colours with normal colour vision and three
/// deficiencies.
[[nodiscard]] std::array<Vec3f, kFrustumPlaneCount> planePalette(const Vec3f& background);

/// How many objects each plane rejected, for strategies that record boxes of objects.
struct PlaneCounts {
    std::array<uint64_t, kFrustumPlaneCount> rejected{};  ///< by FrustumPlane
    uint64_t withoutPlane = 0;                            ///< culled, but not by a single plane
    uint64_t kept = 0;

    bool operator==(const PlaneCounts&) const = default;
};
[[nodiscard]] PlaneCounts countByPlane(const StructureSnapshot& snapshot);

}  // namespace cullscope
