#pragma once

#include <map>
#include <string>

#include "core/experiments/paper_tables.h"

namespace cullscope {

/// Values of a row, by column.
using PaperCells = std::map<std::string, PaperValue>;

/// A note without arguments; `text` is English, marked for translation.
[[nodiscard]] inline Message note(const char* text) { return {text, {}}; }

/// The cells that every table has for a run: the setting's labels, the paper's values for the strategy, and the measured views,
/// frames per second, ratios, and losses where they were counted. The run must have frames.
[[nodiscard]] PaperCells rowCells(const PaperSetting& setting, const RunMeasurement& run);

}  // namespace cullscope
