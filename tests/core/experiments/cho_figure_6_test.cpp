#include "core/experiments/cho_figure_6.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/experiments/experiment_list.h"
#include "core/measure/accuracy.h"
#include "core/visibility/strategy_request.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"
#include "tests/support/table_cells.h"

namespace cullscope::test::cho_figure_6_test {
namespace {

using Json = nlohmann::ordered_json;

const Experiment& experiment() { return findExperiment("vfc-40-views"); }

bool empty(const ResultTable& table, size_t row, const std::string& key) {
    return std::holds_alternative<std::monostate>(valueOf(table, row, key));
}

RunMeasurement run(const std::string& strategy, Facing facing, const std::vector<double>& milliseconds,
                   const std::vector<uint64_t>& considered) {
    RunMeasurement measured;
    measured.strategy = strategyFromText(strategy);
    measured.facing = facing;
    for (size_t pose = 0; pose < milliseconds.size(); ++pose) {
        FrameMeasurement frame;
        frame.pose = pose;
        frame.frameMilliseconds = milliseconds[pose];
        frame.frameTimes = {milliseconds[pose]};
        frame.consideredTriangles = frame.submitted.triangles = considered[pose];
        frame.accuracy = Accuracy{};
        measured.frames.push_back(frame);
    }
    return measured;
}

/// A made-up result: nine bodies of 500 triangles, three views.
MeasureResult madeUp() {
    MeasureResult result;
    result.request = smallExperiment({"all"});
    const uint64_t triangles = result.request.scene->triangleCount();
    result.runs = {run("all", Facing::TwoSided, {100, 100, 100}, {triangles, triangles, triangles}),
                   run("frustum:facing=two-sided", Facing::TwoSided, {50, 20, 10}, {triangles, triangles / 5, triangles / 9}),
                   run("backface", Facing::Front, {80, 80, 80}, {triangles, triangles, triangles}),
                   run("frustum", Facing::Front, {40, 25, 5}, {triangles, triangles / 5, triangles / 9})};
    result.runs[1].summary.fpsOverall = 37.5;
    result.runs[1].summary.cullShare = 0.02;
    result.runs[1].summary.speedupVsTriangles = {5.6, {2.0, 10.0}};
    result.runs[1].summary.ratioToTriangles = {3.75, {2.0, 9.0}};
    result.runs[1].summary.culledFraction = 0.56;
    return result;
}

ResultTable madeUpTable() {
    ResultTable table = emptyTable(experiment());
    addRuns(table, experiment(), experiment().settings[0], madeUp());
    return table;
}

TEST(ChoFigure6, settingIsThePapers) {
    ASSERT_EQ(experiment().settings.size(), 1u);
    const Setting& setting = experiment().settings[0];
    EXPECT_EQ(setting.scene, "field:mesh=mesh:bunny,triangles=5000,n=20,spacing=2.5");
    EXPECT_EQ(setting.path, "walk:40");
    EXPECT_EQ(setting.size, (Viewport{650, 650}));
    EXPECT_EQ(setting.windows, 1);
    EXPECT_THAT(setting.strategies,
                testing::IsSupersetOf({"all", "backface", "frustum", "frustum-octree", "frustum-select", "frustum-query"}));
    EXPECT_THAT(setting.strategies, testing::Contains(setting.shown));
    for (const std::string& strategy : setting.strategies)
        EXPECT_EQ(strategyText(strategyFromText(strategy)), strategy) << "the paper's figures are looked up by it";
    for (const auto& [strategy, cells] : setting.stated) EXPECT_THAT(setting.strategies, testing::Contains(strategy));
}

TEST(ChoFigure6, figuresAreThoseThatThePaperPrints) {
    const auto& paper = experiment().settings[0].stated;
    const auto stated = [&](const std::string& strategy, const std::string& key) {
        return std::get<double>(paper.at(strategy).at(key));
    };
    EXPECT_EQ(stated("all", "paper_fps_mean"), 0.83);
    EXPECT_EQ(stated("frustum-select", "paper_fps_mean"), 10.0);
    EXPECT_EQ(stated("frustum-select", "paper_fps_max"), 33.0);
    EXPECT_EQ(stated("frustum-select", "paper_speedup_vs_all"), 12.0);
    EXPECT_EQ(stated("frustum-select", "paper_culled_fraction"), 0.79);
    EXPECT_EQ(stated("frustum-select", "paper_cull_share"), 0.04);
    EXPECT_EQ(stated("frustum:facing=two-sided", "paper_fps_mean"), 10.0) << "the same boxes, asked otherwise";
    EXPECT_FALSE(paper.contains("frustum")) << "the paper draws both sides";
}

TEST(ChoFigure6, fittedViewsCullWhatThePaperCullsAndCouldGainWhatItGains) {
    const ScenePointer scene = openScene("field:mesh=sphere:triangles=80,n=20,spacing=2.5").scene;
    const CameraPath path = viewsFittedToFigure6(*scene);
    ASSERT_EQ(path.poses.size(), 40u);
    double culled = 0.0, limit = 0.0, most = 0.0;
    for (size_t pose = 0; pose < path.poses.size(); ++pose) {
        const View view(path.camera(pose), {650, 650});
        double kept = 0.0;
        for (size_t i = 0; i < scene->instances().size(); ++i)
            kept +=
                classify(view.frustum(), relativeToEye(scene->instanceBox(i), view.eye())) != Containment::Outside ? 1.0 : 0.0;
        const double share = kept / double(scene->instances().size());
        ASSERT_GT(share, 0.0) << pose;
        culled += (1.0 - share) / 40.0;
        limit += 1.0 / share / 40.0;
        most = std::max(most, 1.0 / share);
    }
    EXPECT_NEAR(culled, 0.79, 0.01);
    EXPECT_NEAR(limit, 12.0, 0.6);
    EXPECT_NEAR(most, 39.8, 4.0);
    const Experiment& fitted = findExperiment("vfc-fitted-views");
    EXPECT_EQ(fitted.settings.front().stated, experiment().settings.front().stated);
    EXPECT_TRUE(fitted.settings.front().views);
}

TEST(ChoFigure6, rowsAreWhatWasMeasured) {
    const ResultTable table = madeUpTable();
    ASSERT_EQ(table.rows.size(), 4u);
    EXPECT_EQ(std::get<std::string>(valueOf(table, 1, "strategy")), "frustum:facing=two-sided");
    EXPECT_EQ(std::get<std::string>(valueOf(table, 1, "facing")), "two-sided");
    EXPECT_EQ(std::get<std::string>(valueOf(table, 3, "facing")), "front");
    EXPECT_EQ(number(table, 1, "paper_fps_mean"), 10.0);
    EXPECT_TRUE(empty(table, 3, "paper_fps_mean"));
    // The one estimate, of the view where it is the largest.
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 1, "speedup_vs_all_max")), (RatioEstimate{10.0, {10.0, 10.0}, false}));
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 3, "speedup_vs_all_max")), (RatioEstimate{20.0, {20.0, 20.0}, false}));
    EXPECT_NEAR(number(table, 1, "culled_fraction_max"), 8.0 / 9.0, 1e-3);
    EXPECT_NEAR(number(table, 1, "no_culling_exceeds"), (1.0 + 5.0 + 9.0) / 3.0, 0.02);
    EXPECT_NEAR(number(table, 1, "no_culling_exceeds_max"), 9.0, 0.02);
    EXPECT_EQ(number(table, 0, "culled_fraction_max"), 0.0);
    EXPECT_EQ(number(table, 1, "culled_fraction"), 0.56);
    EXPECT_EQ(number(table, 1, "cull_share"), 0.02);
    EXPECT_EQ(number(table, 1, "fps_overall"), 37.5);
    EXPECT_EQ(number(table, 1, "missed_pixels"), 0.0);
    EXPECT_EQ(number(table, 1, "poses"), 3.0);
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 1, "speedup_vs_all")).ratio, 5.6) << "the paper quotes a mean of ratios";
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 1, "ratio_to_all")).ratio, 3.75);
    const std::string text = tableText(table);
    EXPECT_THAT(text, testing::HasSubstr("56.0")) << "the share is not in per cent";
}

TEST(ChoFigure6, ratioToAllNeedsAll) {
    MeasureResult result = madeUp();
    result.runs.erase(result.runs.begin());
    ResultTable table = emptyTable(experiment());
    addRuns(table, experiment(), experiment().settings[0], result);
    EXPECT_TRUE(empty(table, 0, "speedup_vs_all_max"));
}

TEST(ChoFigure6, figureShowsWhatWasMeasured) {
    const ResultTable table = madeUpTable();
    ASSERT_EQ(table.plots.size(), 1u);
    const LinePlot& plot = table.plots[0];
    ASSERT_EQ(plot.lines.size(), 5u);
    EXPECT_EQ(plot.lines[4].name, "all ÷ (1 − culled)");
    EXPECT_FALSE(plot.lines[4].dots) << "a bound, told apart from what was measured";
    EXPECT_TRUE(plot.lines[4].dashed);
    EXPECT_NEAR(plot.lines[4].points[2].y, 90.0, 0.2) << "of nine bodies one";
    EXPECT_EQ(plot.lines[1].name, "frustum:facing=two-sided");
    ASSERT_EQ(plot.lines[1].points.size(), 3u);
    EXPECT_EQ(plot.lines[1].points[0].x, 1.0) << "viewpoints count from 1, as in the paper";
    EXPECT_DOUBLE_EQ(plot.lines[1].points[2].y, 100.0);
    EXPECT_TRUE(plot.lines[0].baseline);
    EXPECT_FALSE(plot.lines[0].dashed);
    EXPECT_TRUE(plot.lines[2].dashed) << "front sides alone";
    EXPECT_EQ(plot.lines[1].colour, plot.lines[3].colour) << "one strategy";
    EXPECT_FALSE(plot.lines[1].dashed);
    EXPECT_TRUE(plot.lines[3].dashed);
    std::vector<double> levels;
    for (const PlotReference& reference : plot.references) levels.push_back(reference.y);
    EXPECT_THAT(levels, testing::ElementsAre(33.0, 10.0, 0.83));
}

TEST(ChoFigure6, newPointsReplaceThoseOfAnEarlierView) {
    ResultTable table = emptyTable(experiment());
    ASSERT_EQ(table.plots.size(), 1u);
    EXPECT_TRUE(table.plots[0].lines.empty());
    MeasureResult result = madeUp();
    for (RunMeasurement& each : result.runs) each.frames.resize(1);
    experiment().plotFrames(table, experiment().settings[0], result);
    EXPECT_EQ(table.plots[0].lines.size(), 5u) << "four runs, and what no culling can exceed";
    EXPECT_EQ(table.plots[0].lines[0].points.size(), 1u);
    experiment().plotFrames(table, experiment().settings[0], madeUp());
    EXPECT_EQ(table.plots[0].lines.size(), 5u) << "four runs, and what no culling can exceed";
    EXPECT_EQ(table.plots[0].lines[0].points.size(), 3u);
}

TEST(ChoFigure6, filesHoldTheFigure) {
    const ResultTable table = madeUpTable();
    const Json plot = Json::parse(tablesJson({table}))["experiments"][0]["plots"][0];
    EXPECT_EQ(plot["x"]["scale"], "linear");
    EXPECT_EQ(plot["y"]["scale"], "logarithmic");
    EXPECT_EQ(plot["lines"][1]["name"], "frustum:facing=two-sided");
    EXPECT_EQ(plot["lines"][1]["points"][2]["x"], 3.0);
    EXPECT_EQ(plot["lines"][1]["points"][2]["y"], 100.0);
    EXPECT_EQ(plot["references"][2]["y"], 0.83);
    std::istringstream csv(tableCsv(table));
    std::vector<std::string> lines;
    for (std::string line; std::getline(csv, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 1u + 4 + 1 + 1 + 3);
    EXPECT_EQ(lines[5], "");
    EXPECT_EQ(lines[6],
              "viewpoint,all: frames per second,frustum:facing=two-sided: frames per second,backface: frames per second,"
              "frustum: frames per second,all ÷ (1 − culled): frames per second");
    EXPECT_THAT(lines[9], testing::StartsWith("3,10,100,12.5,200,"));
}

TEST(ChoFigure6, whatWasLeftOutIsSaidOnce) {
    MeasureResult result = madeUp();
    result.leftOut = {{"\"%1\" is not there.", {"frustum-select"}}};
    ResultTable table = emptyTable(experiment());
    addRuns(table, experiment(), experiment().settings[0], result);
    addRuns(table, experiment(), experiment().settings[0], result);
    EXPECT_EQ(table.notes.size(), emptyTable(experiment()).notes.size() + 1) << "once a table";
    EXPECT_EQ(table.notes.back().english(), "\"frustum-select\" is not there.");
}

/// The same code over nine bodies: all strategies of the experiment are measured, and none loses a pixel.
TEST(ChoFigure6, smallWalkIsReproduced) {
    Experiment small = experiment();
    small.settings[0].scene = "field:mesh=star:triangles=500,n=4,spacing=2.5";
    small.settings[0].path = "walk:4";
    small.settings[0].size = {65, 65};
    const ResultTable table = runExperiment(small, {{}, 1});
    EXPECT_FALSE(table.interrupted);
    EXPECT_EQ(table.rows.size() + table.notes.size(), small.settings[0].strategies.size() + emptyTable(small).notes.size())
        << "a strategy has neither a row nor a note";
    EXPECT_THAT(table.brokenPromises, testing::IsEmpty());
    ASSERT_EQ(table.plots[0].lines.size(), table.rows.size() + 1) << "what no culling can exceed";
    for (size_t row = 0; row < table.rows.size(); ++row) {
        EXPECT_EQ(table.plots[0].lines[row].points.size(), 4u);
        EXPECT_EQ(table.plots[0].lines[row].name, std::get<std::string>(valueOf(table, row, "strategy")));
        if (table.plots[0].lines[row].name != "backface") {
            EXPECT_EQ(number(table, row, "missed_pixels"), 0.0);
        }
    }
}

}  // namespace
}  // namespace cullscope::test::cho_figure_6_test
