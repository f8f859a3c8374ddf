#pragma once

#include <string_view>
#include <vector>

#include "core/visibility/strategy.h"

namespace cullscope {

/// A strategy that can be created by its id.
struct RegisteredStrategy {
    StrategyInfo info;
    StrategyPointer (*make)(ParameterSet parameters);
};

/// Every strategy, in the order in which lists show them. A new strategy needs one pair of files and one line there.
[[nodiscard]] const std::vector<RegisteredStrategy>& strategies();

/// The strategy with this id. Throws Error(Usage) naming the known ids where there is none.
[[nodiscard]] const RegisteredStrategy& findStrategy(std::string_view id);

/// Creates a strategy with all parameters at their defaults, or with the given ones.
[[nodiscard]] StrategyPointer makeStrategy(std::string_view id);
[[nodiscard]] StrategyPointer makeStrategy(std::string_view id, ParameterSet parameters);

}  // namespace cullscope
