#pragma once

#include <string>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// One parameter of a strategy over several values: one line of the plot of speed against lost pixels.
struct ParameterSweep {
    std::string strategy;  ///< as `strategyFromText` reads it; its other parameters stay as they are there
    std::string key;
    std::vector<std::string> values;  ///< as on the command line
    std::string automatic{};          ///< the value with which the strategy chooses itself; empty: there is none
};

/// The sweeps that the strategies declare.
[[nodiscard]] const std::vector<ParameterSweep>& builtInSweeps();

/// Sweeps as an experiment of one setting, each an axis: all their values are measured in turns, each strategy once, also where
/// several sweeps contain it. A row is one value of one sweep. `beside`: strategies measured along with them, as
/// `strategyFromText` reads them, with a row each. `cullbench sweep` prints its table; the desktop's statistics page shows the
/// rows of what it measures by the same columns. The caller states scene, path and size. Throws Error(Usage) for a strategy,
/// parameter or value that does not exist.
[[nodiscard]] Experiment sweepExperiment(const std::vector<ParameterSweep>& sweeps, const std::vector<std::string>& beside = {});

}  // namespace cullscope
