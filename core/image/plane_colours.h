#pragma once

#include <array>
#include <cstdint>

#include "core/visibility/structure_snapshot.h"

namespace cullscope {

inline constexpr size_t kFrustumPlaneCount = 6;

/// A colour for each plane of a frustum, for light and dark backgrounds (chosen by the background's luminance). With normal sight
/// and three colour-vision deficiencies they can be told from each other, from the background and from the verdicts' colours.
[[nodiscard]] std::array<Vec3f, kFrustumPlaneCount> planePalette(const Vec3f& background);

/// How many objects each plane left out, of those that a strategy has boxes of.
struct PlaneCounts {
    std::array<uint64_t, kFrustumPlaneCount> rejected{};  ///< by FrustumPlane
    uint64_t withoutPlane = 0;                            ///< left out, and no single plane did it
    uint64_t kept = 0;

    bool operator==(const PlaneCounts&) const = default;
};
[[nodiscard]] PlaneCounts countByPlane(const StructureSnapshot& snapshot);

}  // namespace cullscope
