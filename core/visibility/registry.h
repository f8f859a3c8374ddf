#pragma once

#include <string_view>
#include <vector>

#include "core/visibility/strategy.h"

namespace cullscope {

/// A strategy that can be made by name.
struct RegisteredStrategy {
    StrategyInfo info;
    StrategyPointer (*make)(ParameterSet parameters);
};

/// Every strategy, in the order in which lists show them. A new one is one file pair and one line there.
[[nodiscard]] const std::vector<RegisteredStrategy>& strategies();

/// Throws Error(Usage) naming the known ids where there is none of this id.
[[nodiscard]] const RegisteredStrategy& findStrategy(std::string_view id);

/// Makes a strategy with all parameters at their defaults, or as given.
[[nodiscard]] StrategyPointer makeStrategy(std::string_view id);
[[nodiscard]] StrategyPointer makeStrategy(std::string_view id, ParameterSet parameters);

}  // namespace cullscope
