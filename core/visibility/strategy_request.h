#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/visibility/registry.h"

namespace cullscope {

/// A strategy by its id, with its parameters: what is to be drawn or measured.
struct StrategyRequest {
    std::string id;
    ParameterSet parameters;
};

/// A strategy written as `id` or `id:key=value:key=value`; what is not written is at its default. Throws Error(Usage) naming what
/// is unknown and what there is.
[[nodiscard]] StrategyRequest strategyFromText(std::string_view text);

/// "key=value" for every parameter that is not at its default, in the order of the declarations.
[[nodiscard]] std::vector<std::string> changedParameters(const ParameterSet& parameters);

/// The same backwards: only what is not at its default is written. In tables and plots `separator` is " ".
[[nodiscard]] std::string strategyText(const StrategyRequest& strategy, std::string_view separator = ":");

/// "key=value" in its parts. Throws Error(Usage) where there is no '=' or nothing before it.
[[nodiscard]] std::pair<std::string, std::string> keyAndValue(std::string_view text);

}  // namespace cullscope
