#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope::test {

/// What an experiment does not declare as it must: what it varies, each of that as a column and in its settings; what is
/// measured; and plots of columns that it has. Empty: all is declared.
[[nodiscard]] inline std::vector<std::string> experimentFaults(const Experiment& experiment) {
    using Origin = ResultColumn::Origin;
    std::vector<std::string> faults;
    const auto fault = [&](const std::string& what) { faults.push_back(experiment.id + ": " + what); };
    const auto columnOf = [&](const std::string& key) { return std::ranges::find(experiment.columns, key, &ResultColumn::key); };
    const auto has = [&](const std::string& key) { return columnOf(key) != experiment.columns.end(); };

    if (experiment.axes.empty()) fault("no axes");
    if (experiment.settings.empty()) fault("no settings");
    for (const Axis& axis : experiment.axes) {
        if (axis.values.empty()) fault("axis " + axis.key + " has no values");
        // A sweep's rows name their parameter and its value.
        const bool parameter = axis.kind == Axis::Kind::Parameter;
        for (const std::string& key : parameter ? std::vector<std::string>{"parameter", "value"} : std::vector{axis.key})
            if (!has(key) || columnOf(key)->origin != Origin::Axis) fault("axis " + axis.key + " has no column");
        const auto isIn = [&](const Setting& setting, const CellValue& value) {
            if (axis.kind == Axis::Kind::Strategy)
                return std::ranges::find(setting.strategies, std::get<std::string>(value)) != setting.strategies.end();
            const auto label = setting.labels.find(axis.key);
            return label != setting.labels.end() && label->second == value;
        };
        if (axis.inTurns() && axis.kind != Axis::Kind::Strategy) continue;
        for (const CellValue& value : axis.values)
            if (std::ranges::none_of(experiment.settings, [&](const Setting& setting) { return isIn(setting, value); }))
                fault("a value of axis " + axis.key + " is in no setting");
        for (const Setting& setting : experiment.settings)
            if (setting.labels.contains(axis.key) &&
                std::ranges::none_of(axis.values, [&](const CellValue& value) { return isIn(setting, value); }))
                fault("a setting is not on axis " + axis.key);
    }
    const bool timed = std::ranges::any_of(experiment.settings, &Setting::timed);
    if (timed && std::ranges::none_of(experiment.axes, &Axis::inTurns)) fault("no axis of what is timed in turns");

    std::set<std::string> keys;
    for (const ResultColumn& column : experiment.columns)
        if (!keys.insert(column.key).second) fault("column " + column.key + " twice");
    if (std::ranges::find(experiment.columns, Origin::Measured, &ResultColumn::origin) == experiment.columns.end())
        fault("nothing is measured");

    for (const RowPlot& plot : experiment.plots) {
        if (plot.ofFrames() && !experiment.plotFrames) fault("no function fills plot " + plot.plot.title);
        std::vector<std::string> shown = plot.lines;
        shown.insert(shown.end(), plot.separate.begin(), plot.separate.end());
        for (const auto& [key, values] : plot.rows) shown.push_back(key);
        for (const RowPlot::Column& column : plot.y) shown.push_back(column.key);
        if (!plot.cellsOver.empty()) shown.push_back(plot.cellsOver);
        if (!plot.ofFrames()) shown.push_back(plot.x);
        for (const std::string& key : shown)
            if (!has(key)) fault("plot " + plot.plot.title + " shows \"" + key + "\", which is no column");
    }
    return faults;
}

}  // namespace cullscope::test
