#pragma once

#include <cstdint>
#include <vector>

#include "core/visibility/registry.h"

namespace cullscope::small_feature {

inline constexpr const char* kOutline = "outline";
inline constexpr const char* kThreshold = "threshold";
inline constexpr const char* kOutlineLevels = "outline-levels";
inline constexpr const char* kDetailLevels = "detail-levels";
inline constexpr const char* kHoldFps = "hold-fps";

/// The lines of the listing (featureListing).
enum class FeatureLine : uint8_t { Trees = 1, Planes, Outside, Large, Value, TooSmall, Draw };

[[nodiscard]] Show featureListing();

/// The parameters of `small-feature`.
[[nodiscard]] std::vector<ParameterDeclaration> featureParameters();

}  // namespace cullscope::small_feature
