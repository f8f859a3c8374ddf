#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// A note without arguments; `text` is English, marked for translation.
[[nodiscard]] inline Message note(const char* text) { return {text, {}}; }

/// The cells that every table may show of a run: the setting's labels, what is stated of the strategy, and the measured views,
/// frames per second, ratios, shares, structures, and losses where they were counted. The run must have frames.
[[nodiscard]] Row rowCells(const Setting& setting, const RunMeasurement& run);

/// The cells of each run that has frames.
[[nodiscard]] Rows runRows(const Setting& setting, const MeasureResult& result);

}  // namespace cullscope
