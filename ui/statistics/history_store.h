#pragma once

#include <filesystem>
#include <vector>

#include "core/experiments/store/result_store.h"
#include "ui/session/session.h"
#include "ui/statistics/history_model.h"

namespace cullscope::ui {

/// The result store that experiments of the desktop go into: a file beside the settings.
[[nodiscard]] std::filesystem::path historyStore();

/// Moves the experiments of a history as desktops kept it before there was a store, experiments.json, into one, all or none, and
/// removes the file. Does nothing where there is no such file. Throws Error(Input) where it holds something else.
void takeOldHistory(const std::filesystem::path& json, const store::ResultStore& into);

/// Puts a report into that store; where it cannot be written, a warning says so.
void keepReport(Session& session, const store::Report& report);

/// The newest measurements of a store as a history shows them, the oldest of them first.
[[nodiscard]] std::vector<PastExperiment> pastExperiments(const store::ResultStore& from, size_t most);

}  // namespace cullscope::ui
