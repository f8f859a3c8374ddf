#pragma once

#include "core/measure/meter.h"

namespace cullscope {

/// The summary of a run; `runs` are all runs over its poses, the baselines among them. A run without frames has none.
[[nodiscard]] Summary summaryOf(const RunMeasurement& run, const std::vector<RunMeasurement>& runs, const Scene& scene);
/// The same of a scene of so many triangles.
[[nodiscard]] Summary summaryOf(const RunMeasurement& run, const std::vector<RunMeasurement>& runs, uint64_t triangles);

}  // namespace cullscope
