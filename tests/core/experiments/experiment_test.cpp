#include "core/experiments/experiment.h"

#include <gmock/gmock.h>

#include <map>
#include <set>

#include "core/base/error.h"
#include "core/experiments/sweeps.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::experiment_test {
namespace {

using Kind = Axis::Kind;

std::vector<CellValue> words(const std::vector<std::string>& values) { return {values.begin(), values.end()}; }

TEST(Settings, areTheProductOfTheAxes) {
    const std::vector<Axis> axes{{"scene", "", Kind::Scene, words({"sphere:triangles=20", "torus:triangles=20"})},
                                 {"variant", "", Kind::InTurns, words({"a", "b"})},
                                 {"path", "", Kind::Path, words({"orbit:1", "orbit:2", "orbit:3"})},
                                 {"n", "", Kind::Label, {1.0, 2.0}}};
    const std::vector<Setting> settings = settingsOf(axes);
    ASSERT_EQ(settings.size(), 2u * 3 * 2) << "what is varied in turns makes no settings";
    EXPECT_EQ(settings[0].scene, "sphere:triangles=20");
    EXPECT_EQ(settings[0].path, "orbit:1");
    EXPECT_EQ(settings[1].number("n"), 2.0) << "the last axis varies fastest";
    EXPECT_EQ(settings[1].path, "orbit:1");
    EXPECT_EQ(settings[2].path, "orbit:2");
    EXPECT_EQ(settings[11].scene, "torus:triangles=20");
    EXPECT_EQ(settings[11].words("scene"), "torus:triangles=20") << "its rows say where they were measured";
    EXPECT_FALSE(settings[0].timed());
}

TEST(Settings, haveTheStrategiesOfTheirParameters) {
    Setting common;
    common.strategies = {"all"};
    const std::vector<Setting> settings = settingsOf({{"path", "", Kind::Path, words({"orbit:1", "orbit:2"})},
                                                      {"rows", "", Kind::Parameter, words({"45", "180"}), "spherical:band=10"}},
                                                     common);
    ASSERT_EQ(settings.size(), 2u);
    for (const Setting& setting : settings)
        EXPECT_THAT(setting.strategies, testing::ElementsAre("all", "spherical:rows=45:band=10", "spherical:band=10"));
    EXPECT_THROW((void)settingsOf({{"rows", "", Kind::Parameter, words({"many"}), "spherical"}}), Error);
}

TEST(Settings, haveTheStrategiesOfTheirAxis) {
    const Axis strategies{"strategy", "", Kind::Strategy, words({"all", "frustum:box=length"})};
    EXPECT_TRUE(strategies.inTurns());
    const std::vector<Setting> settings = settingsOf({{"path", "", Kind::Path, words({"orbit:1", "orbit:2"})}, strategies});
    ASSERT_EQ(settings.size(), 2u);
    for (const Setting& setting : settings) EXPECT_THAT(setting.strategies, testing::ElementsAre("all", "frustum:box=length"));
}

TEST(Settings, sayHowTheyAreMeasured) {
    Setting setting;
    setting.strategies = {"all"};
    setting.path = "two eyes";
    setting.views = [](const Scene& scene) { return cameraPath("orbit:2", scene); };
    setting.timing.fixedRepetitions = 3;
    setting.secondsOfAStrategy = 7.0;
    setting.refusalsAreResults = true;
    const ScenePointer scene = smallExperiment({}).scene;
    const MeasureRequest request = measureRequest(setting, scene, 0);
    EXPECT_EQ(request.path.poses.size(), 2u);
    EXPECT_EQ(request.timing.fixedRepetitions, 3);
    EXPECT_EQ(request.secondsOfAStrategy, 7.0);
    EXPECT_TRUE(request.refusalsAreResults);
    EXPECT_EQ(measureRequest(setting, scene, 5).timing.fixedRepetitions, 5) << "the user's word counts";
}

/// An experiment that draws nothing: the square of a label.
Experiment squares() {
    Experiment experiment;
    experiment.id = "squares";
    experiment.axes = {{"n", "n", Kind::Label, {1.0, 2.0, 3.0}}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"square", "square"});
    experiment.plots = {RowPlot{logPlot("Squares", "n", "square"), "n", {{"square"}}}};
    experiment.checks = {exponentCheck("power", {{}, "n", "square"}, {.most = 1.5})};
    experiment.measured = [](const Setting& setting, const ScenePointer& scene, const Progress& progress) {
        EXPECT_EQ(scene, nullptr);
        progress.check();
        return Rows{{{"square", setting.number("n") * setting.number("n")}}};
    };
    return experiment;
}

TEST(RunExperiment, rowsPlotsAndChecksFollowEverySetting) {
    EXPECT_FALSE(squares().needsOpenGl());
    std::vector<size_t> points;
    const ResultTable table = runExperiment(
        squares(), {}, {}, [&](const ResultTable& soFar) { points.push_back(soFar.plots.front().lines.front().points.size()); });
    EXPECT_EQ(points, (std::vector<size_t>{1, 2, 3}));
    ASSERT_EQ(table.rows.size(), 3u);
    EXPECT_EQ(table.value(2, "n"), CellValue(3.0)) << "a row has its setting's labels";
    EXPECT_EQ(table.value(2, "square"), CellValue(9.0));
    EXPECT_EQ(table.value(2, "no such column"), CellValue());
    EXPECT_TRUE(table.checkFailed());
    EXPECT_EQ(table.columns[0].origin, ResultColumn::Origin::Axis);
}

TEST(RunExperiment, stopKeepsTheSettingsMeasured) {
    std::stop_source stop;
    const ResultTable table =
        runExperiment(squares(), {}, {nullptr, stop.get_token()}, [&](const ResultTable&) { stop.request_stop(); });
    EXPECT_TRUE(table.interrupted);
    EXPECT_EQ(table.rows.size(), 1u);
}

TEST(RunExperiment, failureIsThrown) {
    Experiment experiment = squares();
    experiment.measured = [](const Setting&, const ScenePointer&, const Progress&) -> Rows { throwUsage("no"); };
    EXPECT_THROW((void)runExperiment(experiment, {}), Error);
}

TEST(RunExperiment, whatDrawsByItselfSaysByWhichOpenGl) {
    Experiment experiment = squares();
    experiment.draws = true;
    EXPECT_TRUE(experiment.needsOpenGl());
    EXPECT_EQ(runExperiment(experiment, {}).gl.renderer, GlEnvironment::info().renderer);
}

/// A timed experiment without a function of its own has a row for each strategy.
TEST(RunExperiment, timedStrategiesAreRows) {
    Experiment experiment;
    Setting common;
    common.strategies = {"all", "backface", "frustum"};
    common.size = {32, 24};
    experiment.axes = {{"scene", "scene", Kind::Scene, words({"sphere:triangles=20", "torus:triangles=50"})},
                       {"path", "path", Kind::Path, words({"orbit:1", "orbit:2"})}};
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"strategy", "strategy"});
    experiment.columns.push_back({"poses", "views"});
    const ResultTable table = runExperiment(experiment, {{}, 1});
    ASSERT_EQ(table.rows.size(), 2u * 2 * 3);
    EXPECT_EQ(table.value(11, "scene"), CellValue(std::string("torus:triangles=50")));
    EXPECT_EQ(table.value(11, "strategy"), CellValue(std::string("frustum")));
    EXPECT_EQ(table.value(11, "poses"), CellValue(2.0));
}

TEST(RunExperiment, settingsOfOneSceneShareItsStructures) {
    Experiment experiment;
    Setting common;
    common.strategies = {"frustum-octree", "backface"};
    common.size = {32, 24};
    experiment.axes = {{"scene", "scene", Kind::Scene, words({"field:mesh=sphere:triangles=320,n=6", "torus:triangles=50"})},
                       {"path", "path", Kind::Path, words({"orbit:1", "orbit:2", "walk:1"})}};
    experiment.settings = settingsOf(experiment.axes, common);
    experiment.columns = columnsOf(experiment.axes);
    experiment.columns.push_back({"strategy", "strategy"});
    experiment.columns.push_back({"build_ms", "build_ms"});
    const ResultTable table = runExperiment(experiment, {{}, 1});
    ASSERT_EQ(table.rows.size(), 2u * 3 * 2);
    std::map<std::pair<std::string, std::string>, std::set<double>> times;  // each structure's: to the bit
    for (size_t row = 0; row < table.rows.size(); ++row)
        times[{std::get<std::string>(table.value(row, "scene")), std::get<std::string>(table.value(row, "strategy"))}].insert(
            std::get<double>(table.value(row, "build_ms")));
    ASSERT_EQ(times.size(), 4u);
    for (const auto& [structure, built] : times) EXPECT_EQ(built.size(), 1u) << structure.first << ", " << structure.second;
}

TEST(Sweep, rowsAreTheValuesOfEachSweepAndWhatIsMeasuredBeside) {
    // 180 rows and bands of 5° are both the default, so that one run lies on both.
    Experiment experiment =
        sweepExperiment({{"spherical", "rows", {"45", "180"}}, {"spherical", "band", {"5", "10"}}}, {"backface"});
    ASSERT_EQ(experiment.settings.size(), 1u);
    EXPECT_EQ(experiment.axes.size(), 2u);
    EXPECT_EQ(experiment.axes[0].key, "rows");
    Setting& setting = experiment.settings.front();
    setting.scene = "star:seed=7,triangles=500";
    setting.path = "fibonacci:2";
    setting.size = {64, 48};
    const ResultTable table = runExperiment(experiment, {{}, 1});
    ASSERT_EQ(table.rows.size(), 4u + 1);
    std::vector<std::string> points;
    for (size_t row = 0; row < 4; ++row)
        points.push_back(std::get<std::string>(table.value(row, "parameter")) + "=" +
                         std::get<std::string>(table.value(row, "value")));
    EXPECT_THAT(points, testing::ElementsAre("rows=45", "rows=180", "band=5", "band=10"));
    EXPECT_EQ(table.value(1, "fps_overall"), table.value(2, "fps_overall")) << "one run";
    EXPECT_EQ(table.value(4, "strategy"), CellValue(std::string("backface")));
    EXPECT_EQ(table.value(4, "value"), CellValue());
    ASSERT_EQ(table.plots.size(), 1u);
    ASSERT_EQ(table.plots[0].lines.size(), 3u) << "two sweeps and a point";
    EXPECT_EQ(table.plots[0].lines[0].name, "spherical, rows");
    EXPECT_EQ(table.plots[0].lines[0].points.size(), 2u);
}

}  // namespace
}  // namespace cullscope::test::experiment_test
