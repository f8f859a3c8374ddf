#pragma once

#include <string>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope {

/// One parameter of a strategy over several values, all others at their defaults: a line of the plot of speed against loss.
struct ParameterSweep {
    std::string strategy;
    std::string key;
    std::vector<std::string> values;  ///< as on the command line
    std::string automatic{};          ///< the one of them that leaves the choice to the strategy; empty: none does
};

/// The fronts that are offered ready-made. Another one is one line there.
[[nodiscard]] const std::vector<ParameterSweep>& fronts();

/// What is to be measured for fronts: each strategy with each value, once where fronts cross.
[[nodiscard]] std::vector<StrategyRequest> contestants(const std::vector<ParameterSweep>& chosen);

}  // namespace cullscope
