#pragma once

#include <string>
#include <string_view>
#include <utility>

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

/// The same backwards: only what is not at its default is written.
[[nodiscard]] std::string strategyText(const StrategyRequest& strategy);

/// "key=value" in its parts. Throws Error(Usage) where there is no '=' or nothing before it.
[[nodiscard]] std::pair<std::string, std::string> keyAndValue(std::string_view text);

}  // namespace cullscope
