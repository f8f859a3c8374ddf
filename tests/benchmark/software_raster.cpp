// The software depth buffer and scan line beside OpenGL's, with the same picture.
#include "core/experiments/run_rows.h"
#include "core/measure/render_frame.h"
#include "core/raster/picture_shading.h"
#include "core/raster/scan_line.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"

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

/// Milliseconds over all poses of what a method does itself, from the scene to a shaded picture in memory, and of the frame of
/// `all`, in turns.
struct InMemory {
    double all = 0.0, depthBuffer = 0.0, scanLine = 0.0;
};

InMemory inMemory(const MeasureRequest& request) {
    constexpr int kRounds = 9;
    const Scene& scene = *request.scene;
    Renderer renderer;
    const SceneBuffers buffers(request.scene, request.upload);
    Framebuffer target(request.size);
    StructureStore structures;
    const BuiltStrategyPointer all =
        buildStrategy("all", ParameterSet(findStrategy("all").info.parameters), request.scene, structures);
    const ViewStatePointer state = all->begin();
    InMemory sum;
    for (size_t pose = 0; pose < request.path.poses.size(); ++pose) {
        const View view(request.path.camera(pose), request.size);
        const auto shaded = [&](const auto& draw) {
            return timeOf([&] {
                const RasterPicture drawn = draw(trianglesOnRaster(scene, view, Facing::TwoSided));
                return shadedPicture(scene, view, *drawn.picture, {0, 0, request.size}, {});
            });
        };
        const auto times =
            inTurns({[&] { return renderFrame(renderer, buffers, *all, *state, view, target).frameMilliseconds; },
                     [&] { return shaded([](const SceneOnRaster& raster) { return drawDepthBuffer(raster); }); },
                     [&] { return shaded([](const SceneOnRaster& raster) -> RasterPicture { return drawScanLine(raster); }); }},
                    kRounds, 1);
        sum.all += medianOf(times[0]);
        sum.depthBuffer += medianOf(times[1]);
        sum.scanLine += medianOf(times[2]);
    }
    return sum;
}

/// Ratios are of total times over the path's poses, whose frames were drawn in turns.
Rows softwareRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    double all = 0.0;
    const InMemory own = inMemory(result.request);
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
            const double picture = totalOf(run, &FrameMeasurement::cullMilliseconds);
            cells["picture_ms"] = picture / poses;
            cells["picture_speedup"] = all / picture;
            const double shaded = run.strategy.id == "depth-buffer" ? own.depthBuffer : own.scanLine;
            cells["shaded_ms"] = shaded / poses;
            cells["shaded_speedup"] = own.all / shaded;
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
    const std::vector<std::pair<const char*, int>> measured{{"poses", 0},
                                                            {"frame_ms", 2},
                                                            {"frame_speedup", 2},
                                                            {"picture_ms", 2},
                                                            {"picture_speedup", 2},
                                                            {"raster_ms", 2},
                                                            {"shaded_ms", 2},
                                                            {"shaded_speedup", 2},
                                                            {"comparisons", 0},
                                                            {"samples", 0},
                                                            {"missed_beyond_snapping", 0}};
    for (const auto& [key, decimals] : measured) experiment.columns.push_back({key, key, Origin::Measured, decimals});
    const RowFilter depthBuffer{{"strategy", {std::string(kDepthBuffer)}}};
    experiment.checks = {
        everyRowCheck("the depth buffer's picture, times as fast as all", depthBuffer, "picture_speedup", {.least = 4.0}),
        everyRowCheck("shaded in memory, times as fast as the frame of all", depthBuffer, "shaded_speedup", {.least = 4.0}),
        everyRowCheck("its whole frame, shaded and given to OpenGL, times as fast as all", depthBuffer, "frame_speedup",
                      {.least = 4.0})};
    experiment.rowsOfRuns = softwareRows;
    return experiment;
}

}  // namespace cullscope::benchmark
