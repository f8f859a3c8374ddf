#pragma once

#include "core/experiments/experiment.h"

namespace cullscope {

/// A note without arguments; `text` is English, marked for translation.
[[nodiscard]] inline Message note(const char* text) { return {text, {}}; }

/// limitOfCulling() as a setting names it: what tables of culling measure beside the methods.
[[nodiscard]] std::string limitText();
/// The share of the headroom, with its interval.
[[nodiscard]] ResultColumn headroomColumn();

/// The run of a strategy, by its strategyText; null where it has no frames.
[[nodiscard]] const RunMeasurement* runOf(const MeasureResult& result, std::string_view strategy);
/// The mean over a run's views.
template <typename Value>
[[nodiscard]] double meanOfFrames(const RunMeasurement& run, const Value& value) {
    double sum = 0.0;
    for (const FrameMeasurement& frame : run.frames) sum += value(frame);
    return sum / double(run.frames.size());
}
/// How many times as fast a run is as a baseline over the same views; no cell where there is none.
void addRatio(Row& cells, const char* key, const RunMeasurement* baseline, const RunMeasurement& run);

/// The cells that every table may show of a run: the setting's labels, what is stated of the strategy, and the measured views,
/// frames per second, milliseconds, ratios, shares, structures, and losses where they were counted. The run must have frames.
[[nodiscard]] Row rowCells(const Setting& setting, const RunMeasurement& run);

/// The cells of each run that has frames.
[[nodiscard]] Rows runRows(const Setting& setting, const MeasureResult& result);

}  // namespace cullscope
