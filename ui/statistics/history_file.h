#pragma once

#include <filesystem>
#include <vector>

#include "ui/statistics/history_model.h"

namespace cullscope::ui {

/// Where the history of experiments is kept: a file beside the settings.
[[nodiscard]] std::filesystem::path historyFile();

/// Reads the experiments of a file, the oldest first; none where there is no file. Throws Error(Input) where it cannot be read or
/// holds something else.
[[nodiscard]] std::vector<PastExperiment> readHistory(const std::filesystem::path& file);
/// Writes them, whole or not at all, with what a history shows of them. Throws Error(Input) where that fails.
void writeHistory(const std::filesystem::path& file, const std::vector<PastExperiment>& experiments);

}  // namespace cullscope::ui
