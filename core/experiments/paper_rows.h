#pragma once

#include <map>
#include <string>

#include "core/experiments/paper_tables.h"

namespace cullscope {

/// Values of a row, by column.
using PaperCells = std::map<std::string, PaperValue>;

/// A note without arguments; `text` is English, marked for translation.
[[nodiscard]] inline Message note(const char* text) { return {text, {}}; }

/// What a row has of a run in every table: the setting's labels, what the paper states of the strategy, and as measured here the
/// views, frames per second, speed-ups, and losses where they were counted. The run has frames.
[[nodiscard]] PaperCells rowCells(const PaperSetting& setting, const RunMeasurement& run);

}  // namespace cullscope
