#include "core/experiments/plant_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/experiments/plant_rows.h"

namespace cullscope {
namespace {

using namespace plants;

Rows plantRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    for (const RunMeasurement& run : result.runs) {
        if (run.frames.empty()) continue;
        rows.push_back(runCells(setting, result, run));
        rows.back()["per_pipeline"] = double(result.request.scene->triangleCount()) / setting.number(kPipelines);
        rows.back()["components_per_pipeline"] = double(result.request.scene->instances().size()) / setting.number(kPipelines);
    }
    return rows;
}

std::vector<Message> plantNotes() {
    return {
        note(CULLSCOPE_TR("The paper's plants are not to be had, and its tables did not survive: here are generated plants of as "
                          "many pipelines. Of its figures only the conclusion is left, at least 200 % more frames than by "
                          "triangle.")),
        note(CULLSCOPE_TR("The views are of a walk through the plant at half its height, 30° across as in the paper.")),
        note(CULLSCOPE_TR("The paper tests every triangle of the plant at every frame. Here small-feature-triangle has the "
                          "frustum, groups, vector units and every core on its side. Its missed pixels stand beside its "
                          "time.")),
        note(CULLSCOPE_TR("Groups, sizes and draw list are stages of culling: the tests of octrees, those of triangles or "
                          "components by their size, and the list of what is drawn."))};
}

Axis strategyAxis() {
    Axis axis{"strategy", CULLSCOPE_TR("strategy"), Axis::Kind::Strategy, {}};
    for (const char* strategy : {"all", kOctree, kTriangle, kFeature, kBounded}) axis.values.emplace_back(std::string(strategy));
    axis.values.emplace_back(limitText());
    return axis;
}

/// What the two experiments on plants of given sizes have in common.
Experiment ofPlants(const PlantFiguresSize& size, const std::vector<int>& pipelines) {
    Experiment experiment;
    experiment.notes = plantNotes();
    experiment.axes = {{kPipelines, CULLSCOPE_TR("pipelines"), Axis::Kind::Label, axisValues(pipelines)}, strategyAxis()};
    experiment.settings = settingsOf(experiment.axes, commonSetting(size));
    for (Setting& setting : experiment.settings) setting.scene = plantOf(int(setting.number(kPipelines)));
    experiment.columns = plantColumns(experiment.axes);
    experiment.checks = {boundCheck()};
    experiment.rowsOfRuns = plantRows;
    return experiment;
}

Experiment plantMethods(const PlantFiguresSize& size) {
    Experiment experiment = ofPlants(size, size.plants);
    experiment.id = "plant-methods";
    experiment.title = CULLSCOPE_TR("Small-feature culling of process plants, by method");
    experiment.source = "Du et al. 2017, Table 3";
    for (Setting& setting : experiment.settings) {
        setting.path = fmt::format("walk:{}", size.viewsOfPlants);
        setting.views = [path = setting.path, picture = size.size](const Scene& scene) {
            return withField(cameraPath(path, scene), picture);
        };
    }
    LinePlot plot;
    plot.title = CULLSCOPE_TR("Speed against loss");
    plot.x = {CULLSCOPE_TR("frames per second"), PlotScale::Linear, 0.0, 0.0, true};
    plot.y = {CULLSCOPE_TR("missed pixels, share"), PlotScale::Linear, 0.0, 0.0, true};
    experiment.plots = {linesOf(std::move(plot), "fps_overall", "missed_pixel_rate", "strategy")};
    return experiment;
}

/// By how much a strategy's frame takes longer in the largest plant than in the smallest.
std::optional<double> growthOf(const ResultTable& table, const char* strategy) {
    std::vector<PlotPoint> points = pointsOf(table, {{{"strategy", {CellValue(std::string(strategy))}}}, kPipelines, "frame_ms"});
    if (points.size() < 2) return std::nullopt;
    std::ranges::sort(points, {}, &PlotPoint::x);
    return points.back().y / points.front().y;
}

Experiment plantPipelines(const PlantFiguresSize& size) {
    Experiment experiment = ofPlants(size, size.pipelines);
    experiment.id = "plant-pipelines";
    experiment.title = CULLSCOPE_TR("Small-feature culling by the number of pipelines");
    experiment.source = "Du et al. 2017, Figure 7";
    for (Setting& setting : experiment.settings) {
        const int views = setting.number(kPipelines) < size.manyPipelines ? size.views : size.viewsOfMany;
        setting.path = fmt::format("{} parts of the walk", views);
        setting.views = [views, picture = size.size](const Scene& scene) { return partsOfWalk(scene, views, picture); };
    }
    const char* pipelines = CULLSCOPE_TR("pipelines");
    RowPlot culling =
        linesOf(logPlot(CULLSCOPE_TR("Culling by visible leaves"), CULLSCOPE_TR("visible leaves"), CULLSCOPE_TR("groups, ms")),
                "leaves_visible", "groups_ms", "strategy");
    culling.namesExponents = true;
    experiment.plots = {
        linesOf(logPlot(CULLSCOPE_TR("Frames per second by pipelines"), pipelines, CULLSCOPE_TR("frames per second")), kPipelines,
                "fps_overall", "strategy"),
        linesOf(logPlot(CULLSCOPE_TR("Culling by pipelines"), pipelines, CULLSCOPE_TR("culling, ms")), kPipelines, "cull_ms",
                "strategy"),
        std::move(culling)};
    experiment.checks.push_back({"growth of small-feature's frame time from the smallest to the largest plant, of that of all's",
                                 [](const ResultTable& table) -> std::optional<double> {
                                     const std::optional<double> own = growthOf(table, kFeature), all = growthOf(table, "all");
                                     return own && all ? std::optional(*own / *all) : std::nullopt;
                                 },
                                 0.0, 0.5});
    return experiment;
}

}  // namespace

std::vector<Experiment> plantFigures(const PlantFiguresSize& size) {
    return {plantMethods(size), plantPipelines(size), lossCurve(size)};
}

}  // namespace cullscope
