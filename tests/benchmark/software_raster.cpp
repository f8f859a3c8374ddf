// The software depth buffer and scan line beside OpenGL's, with the same picture.
#include "core/experiments/run_rows.h"
#include "core/measure/statistics.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_means.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

/// `all` draws both sides: so do those that are compared with it.
constexpr const char* kDepthBuffer = "depth-buffer:facing=two-sided";
constexpr const char* kScanLine = "scan-line:facing=two-sided";

double figureOf(const FrameMeasurement& frame, const std::string& name) {
    double sum = 0.0;
    for (const NamedFigure& figure : frame.figures)
        if (figure.name == name) sum += figure.value;
    return sum;
}

/// Milliseconds of one of a strategy's stages.
double stageOf(const FrameMeasurement& frame, const std::string& name) {
    double sum = 0.0;
    for (const Stage& stage : frame.stages)
        if (stage.name == name) sum += stage.milliseconds;
    return sum;
}

/// How many times as fast a strategy's own work is as the whole frames of `all`: without what OpenGL does with its picture.
RatioEstimate pictureRatio(const RunMeasurement& all, const RunMeasurement& run) {
    std::vector<ViewTimes> views;
    for (size_t pose = 0; pose < std::min(all.frames.size(), run.frames.size()); ++pose)
        views.push_back({all.frames[pose].frameTimes, run.frames[pose].cullTimes});
    return ratioOfTotals(views);
}

/// All times and ratios are the meter's: the strategies' frames were drawn in turns at every pose.
Rows softwareRows(const Setting& setting, const MeasureResult& result) {
    const auto all = std::ranges::find(result.runs, "all", [](const RunMeasurement& run) { return run.strategy.id; });
    Rows rows;
    for (const RunMeasurement& run : result.runs) {
        if (run.frames.empty()) continue;
        Row cells = rowCells(setting, run);
        cells["triangles"] = double(result.request.scene->triangleCount());
        cells["frame_ms"] = meanOver(run, [](const FrameMeasurement& frame) { return frame.frameMilliseconds; });
        // Of a strategy that makes its picture itself, what it does before its picture is shaded and given to OpenGL.
        if (run.frames.front().ownRaster) {
            cells["picture_ms"] = meanOver(run, [](const FrameMeasurement& frame) { return frame.cullMilliseconds; });
            cells["picture_ratio"] = pictureRatio(*all, run);
            cells["raster_ms"] = meanOver(run, [](const FrameMeasurement& frame) { return stageOf(frame, "rasterising"); });
            cells["comparisons"] = meanOver(run, [](const FrameMeasurement& frame) { return figureOf(frame, "comparisons"); });
            cells["samples"] = meanOver(run, [](const FrameMeasurement& frame) { return figureOf(frame, "samples"); });
            // What its pictures show that OpenGL's item buffer does not: another triangle nearer, farther, or as near.
            uint64_t beyond = 0, extra = 0, differing = 0;
            for (const FrameMeasurement& measured : run.frames) {
                const Accuracy& accuracy = *measured.accuracy;
                beyond += measured.missedBeyondSnapping;
                extra += accuracy.extraPixels;
                differing += accuracy.missedPixels + accuracy.extraPixels + accuracy.unresolvedPixels;
            }
            cells["missed_beyond_snapping"] = double(beyond);
            cells["extra_pixels"] = double(extra);
            cells["differing_pixels"] = double(differing);
            cells["differing_share"] =
                double(differing) / (double(setting.size.width) * double(setting.size.height) * double(run.frames.size()));
        }
        rows.push_back(std::move(cells));
    }
    return rows;
}

}  // namespace

Experiment softwareRaster(const std::vector<std::string>& scenes, const std::string& path) {
    Experiment experiment;
    experiment.id = "software-raster";
    experiment.title = "Pictures made in software beside OpenGL's, both sides, 640 x 480";
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, {scenes.begin(), scenes.end()}},
                       {"path", "path", Axis::Kind::Path, {path}},
                       {"strategy",
                        "strategy",
                        Axis::Kind::Strategy,
                        {std::string("all"), std::string("backface"), std::string(kDepthBuffer), std::string(kScanLine)}}};
    Setting common;
    common.size = {640, 480};
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"triangles", "triangles"});
    const std::vector<ResultColumn> measured{{"poses", "poses", Origin::Measured},
                                             {"frame_ms", "frame, ms", Origin::Measured, 2},
                                             {"ratio_to_all", "x all [95 %]", Origin::Measured, 2},
                                             {"picture_ms", "its picture, ms", Origin::Measured, 2},
                                             {"picture_ratio", "picture x all's frame [95 %]", Origin::Measured, 2},
                                             {"raster_ms", "of it rasterising, ms", Origin::Measured, 2},
                                             {"comparisons", "comparisons", Origin::Measured},
                                             {"samples", "samples", Origin::Measured},
                                             {"missed_beyond_snapping", "missed px", Origin::Measured},
                                             {"extra_pixels", "extra px", Origin::Measured},
                                             {"differing_pixels", "differing px", Origin::Measured},
                                             {"differing_share", "of all", Origin::Measured, 5}};
    experiment.columns.insert(experiment.columns.end(), measured.begin(), measured.end());
    RowPlot frames{logPlot("Frames by the scene's triangles, whole and the picture alone", "triangles", "ms")};
    frames.x = "triangles";
    frames.y = {{"frame_ms", "frame"}, {"picture_ms", "picture"}};
    frames.lines = {"strategy"};
    frames.byX = true;
    experiment.plots = {frames};
    const RowFilter depthBuffer{{"strategy", {std::string(kDepthBuffer)}}, {"scene", {scenes.back()}}};
    const RowFilter inSoftware{{"strategy", {std::string(kDepthBuffer), std::string(kScanLine)}}};
    experiment.checks = {
        everyRowCheck("missed pixels beyond snapping", inSoftware, "missed_beyond_snapping", {.most = 0.0}),
        everyRowCheck("share of pixels that show another triangle than OpenGL's", inSoftware, "differing_share", {.most = 0.001}),
        everyRowCheck("the depth buffer's picture, times as fast as all", depthBuffer, "picture_ratio", {.least = 4.0}),
        everyRowCheck("its whole frame, shaded and given to OpenGL, times as fast as all", depthBuffer, "ratio_to_all",
                      {.least = 4.0})};
    experiment.rowsOfRuns = softwareRows;
    return experiment;
}

}  // namespace cullscope::benchmark
