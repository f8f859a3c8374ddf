#pragma once

#include <string>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope {

/// One parameter of a strategy over several values, all others at their defaults: one line of the plot of speed against lost
/// pixels.
struct ParameterSweep {
    std::string strategy;
    std::string key;
    std::vector<std::string> values;  ///< as on the command line
    std::string automatic{};          ///< the value with which the strategy chooses itself; empty: there is none
};

/// The sweeps that the strategies declare.
[[nodiscard]] const std::vector<ParameterSweep>& builtInSweeps();

/// The strategies with parameters that the sweeps need measured; each once, also where several sweeps contain it.
[[nodiscard]] std::vector<StrategyRequest> requestsOf(const std::vector<ParameterSweep>& chosen);

}  // namespace cullscope
