#include "core/experiments/plant_figures.h"

#include <gmock/gmock.h>

#include "core/experiments/checks.h"
#include "tests/support/experiment_faults.h"
#include "tests/support/gl_environment.h"

namespace cullscope::test::plant_figures_test {
namespace {

PlantFiguresSize quick() {
    PlantFiguresSize size;
    size.plants = {2};
    size.viewsOfPlants = 2;
    size.pipelines = {2, 4};
    size.views = 2;
    size.manyPipelines = 3;
    size.viewsOfMany = 1;
    size.curvePipelines = 2;
    size.sides = {0.5, 4, 16};
    size.distances = {4};
    size.size = {96, 54};
    return size;
}

const Experiment& experiment(const std::string& id) {
    static const std::vector<Experiment> kExperiments = plantFigures(quick());
    return *std::ranges::find(kExperiments, id, &Experiment::id);
}

double number(const ResultTable& table, size_t row, const char* column) {
    const std::optional<double> value = numberOf(table.value(row, column));
    EXPECT_TRUE(value.has_value()) << column << " in row " << row;
    return value.value_or(0.0);
}

std::string words(const ResultTable& table, size_t row, const char* column) {
    const CellValue value = table.value(row, column);
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr ? std::string() : *text;
}

bool has(const ResultTable& table, size_t row, const char* column) { return numberOf(table.value(row, column)).has_value(); }

TEST(PlantFigures, declareWhatTheyShow) {
    for (const char* id : {"plant-methods", "plant-pipelines", "plant-losses"})
        EXPECT_THAT(experimentFaults(experiment(id)), testing::IsEmpty());
}

TEST(PlantFigures, methodsHaveTheirRatiosStagesAndBounds) {
    const ResultTable table = runExperiment(experiment("plant-methods"), {});
    ASSERT_EQ(table.rows.size(), 6u);
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const std::string strategy = words(table, row, "strategy");
        SCOPED_TRACE(strategy);
        EXPECT_GE(number(table, row, "components_per_pipeline"), 20.0);
        EXPECT_GE(number(table, row, "per_pipeline"), 1'000.0);
        EXPECT_EQ(number(table, row, "poses"), 2.0);
        EXPECT_EQ(number(table, row, "ratio_to_octree") == 1.0, strategy == "frustum-octree");
        EXPECT_EQ(number(table, row, "ratio_to_triangle") == 1.0, strategy == "small-feature-triangle");
        EXPECT_EQ(has(table, row, "paper_ratio_to_triangle"), strategy == "small-feature");
        EXPECT_EQ(has(table, row, "leaves_visible"), strategy == "small-feature");
        EXPECT_EQ(has(table, row, "lost_at_most"), strategy == "small-feature-bounded");
        EXPECT_EQ(has(table, row, "groups_ms"), strategy != "all" && strategy != "oracle");
        EXPECT_EQ(has(table, row, "sizes_ms"), strategy == "small-feature-triangle" || strategy == "small-feature-bounded");
        EXPECT_NEAR(number(table, row, "cull_ms") + number(table, row, "draw_ms"), number(table, row, "frame_ms"), 1e-9);
    }
    EXPECT_FALSE(table.checkFailed());
    ASSERT_EQ(table.plots.size(), 1u);
    EXPECT_EQ(table.plots[0].lines.size(), 6u);
}

TEST(PlantFigures, viewsAreThirtyDegreesWideAndFewerInLargePlants) {
    const ResultTable table = runExperiment(experiment("plant-pipelines"), {});
    ASSERT_EQ(table.rows.size(), 12u);
    for (size_t row = 0; row < 12; ++row) EXPECT_EQ(number(table, row, "poses"), row < 6 ? 2.0 : 1.0);
    ASSERT_EQ(table.plots.size(), 3u);
    for (const LinePlot& plot : table.plots) EXPECT_GE(plot.lines.size(), 1u) << plot.title;
    EXPECT_TRUE(table.checks[1].value.has_value());
    const ScenePointer scene = openScene("plant:pipelines=2", {}).scene;
    const CameraPath path = pathOf(experiment("plant-pipelines").settings[0], *scene);
    const View view(path.camera(0), {96, 54});
    EXPECT_NEAR(view.frustum().tanHalfWidth, std::tan(Angle::fromDegrees(15.0).radians()), 1e-12);
}

TEST(PlantFigures, growthIsHeldAgainstThatOfDrawingAll) {
    const Experiment& pipelines = experiment("plant-pipelines");
    const auto growth = [&](double largest) {
        ResultTable table = emptyTable(pipelines);
        const auto add = [&](double plant, const char* strategy, double frame) {
            table.addRow({{"pipelines", plant}, {"strategy", std::string(strategy)}, {"frame_ms", frame}});
        };
        add(2, "all", 10);
        add(2, "small-feature", 5);
        add(4, "all", 100);
        add(4, "small-feature", largest);
        return checked(pipelines.checks, table)[1];
    };
    EXPECT_DOUBLE_EQ(*growth(20).value, 0.4);
    EXPECT_TRUE(growth(20).holds());
    EXPECT_FALSE(growth(30).holds());
}

TEST(PlantFigures, curveHasEveryThresholdOfEveryMethodAndTakesAnotherScene) {
    const Experiment own = experiment("plant-losses").ofScene("field:mesh=sphere:triangles=80,n=3,spacing=2.5");
    const ResultTable table = runExperiment(own, {});
    ASSERT_EQ(table.rows.size(), 10u);
    EXPECT_EQ(words(table, 9, "method"), "oracle");
    for (size_t row = 0; row < 9; ++row) {
        EXPECT_EQ(number(table, row, "side_px"), quick().sides[row / 3]);
        EXPECT_THAT(words(table, row, "scene"), testing::StartsWith("field:"));
        EXPECT_EQ(has(table, row, "lost_at_most"), words(table, row, "method") == "small-feature-bounded");
    }
    EXPECT_FALSE(table.checkFailed());
    ASSERT_EQ(table.plots.size(), 2u);
    EXPECT_EQ(table.plots[1].lines.size(), 3u);
    // What misses nothing has its line, too.
    ASSERT_EQ(table.plots[0].lines.size(), 3u);
    const PlotRange y = rangeAlongY(table.plots[0]);
    for (const PlotLine& line : table.plots[0].lines) {
        EXPECT_EQ(line.points.size(), 3u) << line.name;
        for (const PlotPoint& point : line.points) EXPECT_TRUE(y.places(point.y)) << line.name;
    }
    ASSERT_FALSE(table.plots[0].y.ticks.empty());
    EXPECT_EQ(table.plots[0].y.ticks.front().label, "0");
    const auto side = std::ranges::find(table.columns, std::string("side_px"), &ResultColumn::key);
    EXPECT_EQ(valueText(*side, table.value(0, "side_px")), "0.50");
    // 14.33 pixels of 1,920 are the paper's 0.002.
    PlantFiguresSize paper;
    paper.sides = {14.33};
    const std::vector<Experiment> experiments = plantFigures(paper);
    EXPECT_THAT(experiments.back().settings[0].strategies,
                testing::ElementsAre("frustum-octree", "oracle", testing::StartsWith("small-feature:threshold=0.00199"),
                                     testing::StartsWith("small-feature-triangle:threshold=0.00199"),
                                     "small-feature-bounded:pixels=205"));
}

}  // namespace
}  // namespace cullscope::test::plant_figures_test
