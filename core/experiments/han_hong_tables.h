#pragma once

#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// Tables 1 to 5 of Han & Hong 2008, "An Efficient Rendering Method of Object Representation Based on Spherical Coordinate
/// System", with the paper's numbers as printed.
[[nodiscard]] std::vector<Experiment> hanHongTables();

}  // namespace cullscope
