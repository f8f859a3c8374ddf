#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "core/visibility/registry.h"

namespace cullscope {

/// A strategy by its id, with its parameters, as requested for drawing or measuring.
struct StrategyRequest {
    std::string id;
    ParameterSet parameters;
};

/// Parses a strategy written as `id` or `id:key=value:key=value`; other parameters are at their defaults. Throws Error(Usage)
/// naming an unknown id or key and the known ones.
[[nodiscard]] StrategyRequest strategyFromText(std::string_view text);

/// The inverse: writes only the parameters that are not at their defaults.
[[nodiscard]] std::string strategyText(const StrategyRequest& strategy);

/// Splits "key=value". Throws Error(Usage) where there is no '=' or no key before it.
[[nodiscard]] std::pair<std::string, std::string> keyAndValue(std::string_view text);

}  // namespace cullscope
