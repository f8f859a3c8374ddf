// `octree-query` beside the baselines: where much is hidden, and on real scenes.
#include <array>

#include "tests/benchmark/experiments.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr std::array kStrategies{"all",
                                 "backface",
                                 "frustum-octree",
                                 "octree-query",
                                 "octree-query:batch=1",
                                 "octree-query:ask=leaves",
                                 "octree-query:latency=1"};
constexpr const char *kLayersPath = "front:8", *kOthersPath = "walk:16";

/// All strategies on one scene.
Setting settingOf(const std::string& scene, const char* path, const Axis& strategies, const Viewport& size) {
    Setting common;
    common.shown = "octree-query";
    common.size = size;
    return settingsOf(
               {{"scene", "", Axis::Kind::Scene, {scene}}, {"path", "", Axis::Kind::Path, {std::string(path)}}, strategies},
               common)
        .front();
}

RowPlot speedByShare() {
    RowPlot described;
    described.plot.title = "Speed by what is left out, a point for each scene";
    described.plot.x = {"left out, share of the triangles", PlotScale::Linear, 0.0, 1.0};
    described.plot.y = {"x backface", PlotScale::Logarithmic};
    described.x = "culled_fraction";
    described.y = {{"ratio_to_backface"}};
    described.lines = {"strategy"};
    described.byX = true;
    return described;
}

}  // namespace

Experiment octreeQueryBesideBackface(const std::string& layers, const std::vector<std::string>& others, const Viewport& size) {
    constexpr double kTimesBackface = 3.0;
    Experiment experiment;
    experiment.id = "octree-query";
    experiment.title = "octree-query beside the baselines, " + std::to_string(size.width) + " x " + std::to_string(size.height);
    const Axis strategies{"strategy", "strategy", Axis::Kind::Strategy, {kStrategies.begin(), kStrategies.end()}};
    experiment.settings = {settingOf(layers, kLayersPath, strategies, size)};
    std::vector<CellValue> scenes{layers}, paths{std::string(kLayersPath)}, waiting;
    for (const std::string& scene : others) {
        experiment.settings.push_back(settingOf(scene, kOthersPath, strategies, size));
        scenes.emplace_back(scene);
    }
    if (!others.empty()) paths.emplace_back(std::string(kOthersPath));
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, scenes}, {"path", "path", Axis::Kind::Path, paths}, strategies};
    experiment.columns = columnsOf(experiment.axes);
    experiment.plots = {speedByShare()};
    const std::vector<ResultColumn> measured{{"fps_overall", "fps, all views", Origin::Measured, 1},
                                             {"ratio_to_all", "x all [95 %]", Origin::Measured, 2},
                                             {"ratio_to_backface", "x backface [95 %]", Origin::Measured, 2},
                                             {"culled_fraction", "culled, %", Origin::Measured, 1, 100.0},
                                             {"missed_pixels", "missed px", Origin::Measured},
                                             {"build_ms", "build, ms", Origin::Measured, 2},
                                             {"structure_bytes", "bytes", Origin::Measured}};
    experiment.columns.insert(experiment.columns.end(), measured.begin(), measured.end());
    for (const char* strategy : {"octree-query", "octree-query:batch=1", "octree-query:ask=leaves"})
        waiting.emplace_back(std::string(strategy));
    experiment.checks = {
        everyRowCheck("octree-query on layers, times the speed of backface",
                      {{"scene", {layers}}, {"strategy", {std::string("octree-query")}}}, "ratio_to_backface", {kTimesBackface}),
        everyRowCheck("pixels that octree-query misses where it waits for the answers", {{"strategy", waiting}}, "missed_pixels",
                      {0.0, 0.0})};
    return experiment;
}

}  // namespace cullscope::benchmark
