// `octree-query` beside the baselines: where much is hidden, and on real scenes.
#include "tests/benchmark/experiments.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

const std::vector<std::string> kStrategies{"all",
                                           "backface",
                                           "frustum-octree",
                                           "octree-query",
                                           "octree-query:batch=1",
                                           "octree-query:ask=leaves",
                                           "octree-query:latency=1"};

Setting settingOf(const std::string& scene, const char* path, const Viewport& size) {
    Setting setting;
    setting.scene = scene;
    setting.strategies = kStrategies;
    setting.shown = "octree-query";
    setting.path = path;
    setting.size = size;
    setting.labels = {{"scene", scene}, {"path", std::string(path)}};
    return setting;
}

}  // namespace

Experiment octreeQueryBesideBackface(const std::string& layers, const std::vector<std::string>& others, const Viewport& size) {
    constexpr double kTimesBackface = 3.0;
    Experiment experiment;
    experiment.id = "octree-query";
    experiment.title = "octree-query beside the baselines, " + std::to_string(size.width) + " x " + std::to_string(size.height);
    experiment.settings = {settingOf(layers, "front:8", size)};
    std::vector<CellValue> scenes{layers}, waiting;
    for (const std::string& scene : others) {
        experiment.settings.push_back(settingOf(scene, "walk:16", size));
        scenes.emplace_back(scene);
    }
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, scenes},
                       {"path", "path", Axis::Kind::Path, {std::string("front:8"), std::string("walk:16")}}};
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"strategy", "strategy", Origin::Axis});
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
