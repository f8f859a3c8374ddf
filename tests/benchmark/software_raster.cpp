// The software depth buffer and scan line beside OpenGL's, with the same picture.
#include "core/experiments/run_rows.h"
#include "tests/benchmark/experiments.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

/// `all` draws both sides: so do those that are compared with it.
constexpr const char* kDepthBuffer = "depth-buffer:facing=two-sided";
constexpr const char* kScanLine = "scan-line:facing=two-sided";

double totalOf(const RunMeasurement& run, double FrameMeasurement::*milliseconds) {
    double sum = 0.0;
    for (const FrameMeasurement& frame : run.frames) sum += frame.*milliseconds;
    return sum;
}

double figureOf(const RunMeasurement& run, const std::string& name) {
    double sum = 0.0;
    for (const FrameMeasurement& frame : run.frames)
        for (const NamedFigure& figure : frame.figures)
            if (figure.name == name) sum += figure.value;
    return sum;
}

/// Milliseconds of one of a strategy's stages.
double stageOf(const RunMeasurement& run, const std::string& name) {
    double sum = 0.0;
    for (const FrameMeasurement& frame : run.frames)
        for (const Stage& stage : frame.stages)
            if (stage.name == name) sum += stage.milliseconds;
    return sum;
}

/// Ratios are of total times over the path's poses, whose frames were drawn in turns.
Rows softwareRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    double all = 0.0;
    for (const RunMeasurement& run : result.runs)
        if (run.strategy.id == "all") all = totalOf(run, &FrameMeasurement::frameMilliseconds);
    for (const RunMeasurement& run : result.runs) {
        if (run.frames.empty()) continue;
        const double poses = double(run.frames.size()), frame = totalOf(run, &FrameMeasurement::frameMilliseconds);
        Row cells = rowCells(setting, run);
        cells["frame_ms"] = frame / poses;
        cells["frame_speedup"] = all / frame;
        // Of a strategy that makes its picture itself, what it does before its picture is given to OpenGL.
        if (run.frames.front().ownRaster) {
            const double own = totalOf(run, &FrameMeasurement::cullMilliseconds);
            cells["picture_ms"] = own / poses;
            cells["picture_speedup"] = all / own;
            cells["raster_ms"] = stageOf(run, "rasterising") / poses;
            cells["comparisons"] = figureOf(run, "comparisons") / poses;
            cells["samples"] = figureOf(run, "samples") / poses;
            uint64_t beyond = 0;
            for (const FrameMeasurement& measured : run.frames) beyond += measured.missedBeyondSnapping;
            cells["missed_beyond_snapping"] = double(beyond);
        }
        rows.push_back(std::move(cells));
    }
    return rows;
}

}  // namespace

Experiment softwareRaster(const std::string& scene, const std::string& path) {
    Experiment experiment;
    experiment.id = "software-raster";
    experiment.title = "Pictures made in software beside OpenGL's, both sides, 640 x 480";
    Setting setting;
    setting.scene = scene;
    setting.strategies = {"all", "backface", kDepthBuffer, kScanLine};
    setting.path = path;
    setting.size = {640, 480};
    experiment.settings = {setting};
    experiment.columns = {{"strategy", "strategy", Origin::Axis}};
    const std::vector<std::pair<const char*, int>> measured{
        {"poses", 0},       {"frame_ms", 2},        {"frame_speedup", 2},
        {"picture_ms", 2},  {"picture_speedup", 2}, {"raster_ms", 2},
        {"comparisons", 0}, {"samples", 0},         {"missed_beyond_snapping", 0}};
    for (const auto& [key, decimals] : measured) experiment.columns.push_back({key, key, Origin::Measured, decimals});
    const RowFilter depthBuffer{{"strategy", {std::string(kDepthBuffer)}}};
    experiment.checks = {
        everyRowCheck("the depth buffer's picture, times as fast as all", depthBuffer, "picture_speedup", {.least = 4.0}),
        everyRowCheck("its whole frame, shaded and given to OpenGL, times as fast as all", depthBuffer, "frame_speedup", {})};
    experiment.rowsOfRuns = softwareRows;
    return experiment;
}

}  // namespace cullscope::benchmark
