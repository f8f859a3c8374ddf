#pragma once

#include <string_view>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// Every experiment that `cullbench reproduce` and the desktop offer, in the order in which lists show them.
[[nodiscard]] const std::vector<Experiment>& knownExperiments();
/// Stands for all of them where one is asked for by its id.
inline constexpr const char* kAllExperiments = "all";

/// The experiment with this id. Throws Error(Usage) naming the known ids where there is none.
[[nodiscard]] const Experiment& findExperiment(std::string_view id);

}  // namespace cullscope
