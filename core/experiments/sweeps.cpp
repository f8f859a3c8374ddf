#include "core/experiments/sweeps.h"

#include <algorithm>

#include "core/experiments/run_rows.h"
#include "core/measure/field_figures.h"
#include "core/visibility/registry.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

using Origin = ResultColumn::Origin;

Axis axisOf(const ParameterSweep& sweep) {
    return {sweep.key, sweep.key, Axis::Kind::Parameter, {sweep.values.begin(), sweep.values.end()}, sweep.strategy};
}

/// Of the field's figures those for which a table on screen has room.
bool inText(std::string_view key) {
    return key == "triangle_false_negative_rate" || key == "triangle_false_positive_rate" || key == "pixel_error_rate" ||
           key == "popping_events_per_1000_frames";
}

std::vector<ResultColumn> sweepColumns() {
    std::vector<ResultColumn> columns{{"strategy", CULLSCOPE_TR("strategy"), Origin::Axis},
                                      {"parameter", CULLSCOPE_TR("parameter"), Origin::Axis},
                                      {"value", CULLSCOPE_TR("value"), Origin::Axis},
                                      {"fps_overall", CULLSCOPE_TR("fps, all views"), Origin::Measured, 1},
                                      {"ratio_to_same_sides", CULLSCOPE_TR("× same sides [95 %]"), Origin::Measured, 2},
                                      {"same_sides_baseline", CULLSCOPE_TR("baseline, same sides"), Origin::Measured},
                                      headroomColumn(),
                                      {"ratio_to_all", CULLSCOPE_TR("× all [95 %]"), Origin::Measured, 2},
                                      {"ratio_to_backface", CULLSCOPE_TR("× backface [95 %]"), Origin::Measured, 2},
                                      {"fps_min", CULLSCOPE_TR("fps min"), Origin::Measured, 1},
                                      {"fps_max", CULLSCOPE_TR("fps max"), Origin::Measured, 1},
                                      {"culled_fraction", CULLSCOPE_TR("culled, %"), Origin::Measured, 1, 100.0},
                                      {"cull_share", CULLSCOPE_TR("culling, % of the frame"), Origin::Measured, 2, 100.0},
                                      {"promise", CULLSCOPE_TR("promise"), Origin::Measured},
                                      {"missed_pixels", CULLSCOPE_TR("missed px"), Origin::Measured},
                                      {"missed_beyond_snapping", CULLSCOPE_TR("beyond snapping, px"), Origin::Measured},
                                      {"missed_pixel_rate", CULLSCOPE_TR("missed ppm"), Origin::Measured, 0, 1e6},
                                      {"largest_hole_px", CULLSCOPE_TR("largest hole, px"), Origin::Measured},
                                      {"worst_pose", CULLSCOPE_TR("worst view"), Origin::Measured},
                                      {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 1},
                                      {"structure_bytes", CULLSCOPE_TR("bytes"), Origin::Measured},
                                      {"poses", CULLSCOPE_TR("views"), Origin::Measured}};
    for (const FieldFigure& figure : fieldFigures())
        columns.push_back({figure.key, figure.title, Origin::Measured, figure.decimals, figure.scale, !inText(figure.key), true});
    for (ResultColumn& column : columns)
        if (column.key.starts_with("ratio_to_")) column.estimated = true;
    return columns;
}

/// Speed against loss: a line for each sweep, a point for what lies on none.
RowPlot speedAgainstLoss() {
    RowPlot described;
    described.plot.title = CULLSCOPE_TR("Speed against loss");
    described.plot.x = {CULLSCOPE_TR("× a baseline that draws the same sides"), PlotScale::Linear, 0.0, 0.0, true};
    described.plot.y = {CULLSCOPE_TR("missed pixels, share"), PlotScale::Linear, 0.0, 0.0, true};
    described.x = "ratio_to_same_sides";
    described.y = {{"missed_pixel_rate"}};
    described.lines = {"strategy", "parameter"};
    return described;
}

const RunMeasurement* runOf(const MeasureResult& result, const StrategyRequest& request) {
    const auto found = std::find_if(result.runs.begin(), result.runs.end(), [&](const RunMeasurement& run) {
        return run.strategy.id == request.id && run.strategy.parameters == request.parameters;
    });
    return found == result.runs.end() || found->frames.empty() ? nullptr : &*found;
}

Rows sweepRows(const std::vector<Axis>& axes, const Setting& setting, const MeasureResult& result) {
    Rows rows;
    std::vector<const RunMeasurement*> onSweeps;
    for (const Axis& axis : axes)
        for (const CellValue& value : axis.values) {
            StrategyRequest request = strategyFromText(axis.strategy);
            request.parameters.setFromText(axis.key, std::get<std::string>(value));
            const RunMeasurement* run = runOf(result, request);
            if (run == nullptr) continue;
            onSweeps.push_back(run);
            rows.push_back(rowCells(setting, *run));
            rows.back()["strategy"] = axis.strategy;
            rows.back()["parameter"] = axis.key;
            rows.back()["value"] = value;
        }
    for (const RunMeasurement& run : result.runs)
        if (!run.frames.empty() && std::find(onSweeps.begin(), onSweeps.end(), &run) == onSweeps.end())
            rows.push_back(rowCells(setting, run));
    if (result.limit && !result.limit->frames.empty() && runOf(result, result.limit->strategy) == nullptr)
        rows.push_back(rowCells(setting, *result.limit));
    return rows;
}

}  // namespace

const std::vector<ParameterSweep>& builtInSweeps() {
    static const std::vector<ParameterSweep> kSweeps = [] {
        std::vector<ParameterSweep> sweeps;
        for (const RegisteredStrategy& strategy : strategies())
            for (const DeclaredSweep& sweep : strategy.info.sweeps)
                sweeps.push_back({strategy.info.id, sweep.key, sweep.values, sweep.automatic});
        return sweeps;
    }();
    return kSweeps;
}

Experiment sweepExperiment(const std::vector<ParameterSweep>& sweeps, const std::vector<std::string>& beside) {
    Experiment experiment;
    experiment.id = "sweep";
    experiment.title = CULLSCOPE_TR("Speed against loss");
    for (const ParameterSweep& sweep : sweeps) experiment.axes.push_back(axisOf(sweep));
    Setting common;
    common.strategies = beside;
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = sweepColumns();
    experiment.plots = {speedAgainstLoss()};
    experiment.rowsOfRuns = [axes = experiment.axes](const Setting& setting, const MeasureResult& result) {
        return sweepRows(axes, setting, result);
    };
    return experiment;
}

}  // namespace cullscope
