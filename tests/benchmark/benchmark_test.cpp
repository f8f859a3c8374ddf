// Every benchmark at its smallest point, so that none rots: what it measures has its columns, plots and files.
#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/experiments/lecture_table.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/in_turns.h"
#include "tests/support/experiment_faults.h"
#include "tests/support/gl_environment.h"

namespace cullscope::benchmark::benchmark_test {
namespace {

/// Expects that the rows lie on the experiment's axes, and that the table holds all that was measured.
void expectWhole(const Experiment& experiment, const ResultTable& table) {
    ASSERT_FALSE(table.rows.empty());
    for (size_t row = 0; row < table.rows.size(); ++row)
        for (const Axis& axis : experiment.axes) {
            // A tessellation has about as many faces as were asked for.
            if (axis.key == "faces" || std::holds_alternative<std::monostate>(table.value(row, axis.key))) continue;
            EXPECT_THAT(axis.values, testing::Contains(table.value(row, axis.key))) << axis.key << " of row " << row;
        }
    for (size_t column = 0; column < table.columns.size(); ++column) {
        const auto filled = [&](const std::vector<CellValue>& row) {
            return !std::holds_alternative<std::monostate>(row[column]);
        };
        EXPECT_TRUE(std::any_of(table.rows.begin(), table.rows.end(), filled)) << table.columns[column].key << " is empty";
    }
    EXPECT_EQ(table.checks.size(), experiment.checks.size());
}

/// Runs an experiment whose rows may hold no value that it has no column for.
ResultTable run(Experiment experiment, int repetitions = 0) {
    if (!experiment.measured) return runExperiment(experiment, {{}, repetitions});
    experiment.measured = [measured = experiment.measured, columns = experiment.columns](
                              const Setting& setting, const ScenePointer& scene, const Progress& progress) {
        Rows rows = measured(setting, scene, progress);
        for (const Row& row : rows)
            for (const auto& [key, value] : row)
                EXPECT_NE(std::ranges::find(columns, key, &ResultColumn::key), columns.end()) << key << " has no column";
        return rows;
    };
    return runExperiment(experiment, {});
}

/// One setting of an experiment.
ResultTable runOne(Experiment experiment, size_t setting) {
    const std::vector<Setting> all = experiment.settings;
    experiment.settings = {all.at(setting)};
    return run(std::move(experiment));
}

TEST(InTurns, allTakeTheirTurnInEveryRoundAndTheWarmUpDoesNotCount) {
    std::string order;
    double number = 0.0;
    const auto contestant = [&](char name) {
        return [&order, &number, name] {
            order += name;
            return ++number;
        };
    };
    const std::vector<std::vector<double>> numbers = inTurns({contestant('a'), contestant('b')}, 2, 1);
    EXPECT_EQ(order, "ababab");
    EXPECT_THAT(numbers, testing::ElementsAre(testing::ElementsAre(3, 5), testing::ElementsAre(4, 6)));
}

TEST(InTurns, ratioIsTheOneEstimate) {
    const std::vector<double> slow{20, 21, 19, 40, 20}, fast{10, 11, 10, 12, 9};
    const ViewTimes times{slow, fast};
    EXPECT_EQ(ratioInTurns(slow, fast), ratioOfTotals({&times, 1}));
    EXPECT_EQ(ratioInTurns(slow, fast).ratio, 2.0);
}

TEST(Benchmarks, declareWhatTheyVaryAndShow) {
    const Experiment experiments[] = {frustumTests(10'000'000),
                                      frustumTests(1'000),
                                      sphericalMapsGrowth(),
                                      losslessBuild({"bunny"}, 1),
                                      losslessGrowth(),
                                      losslessCull(),
                                      losslessLayouts({"torus", "bunny"}),
                                      softwareRaster({"torus"}, "case-2"),
                                      octreeQueryBesideBackface("layers:count=2,triangles=8", {"bunny"}),
                                      octreeQueryBesideBackface("layers:count=2,triangles=8", {}),
                                      occlusionBuffers("torus", "bunny", 2, {64, 48})};
    for (const Experiment& experiment : experiments) {
        EXPECT_THAT(test::experimentFaults(experiment), testing::IsEmpty()) << experiment.id;
        EXPECT_FALSE(experiment.plots.empty()) << experiment.id;
    }
}

TEST(Benchmarks, frustumTestsKeepWhatIsInView) {
    const Experiment experiment = frustumTests(100'000);
    for (const size_t setting : {size_t{0}, experiment.settings.size() - 2}) {
        const ResultTable table = runOne(experiment, setting);
        ASSERT_FALSE(table.rows.empty());
        const double objects = *numberOf(table.value(0, "objects"));
        for (size_t row = 0; row < table.rows.size(); ++row) {
            EXPECT_GT(*numberOf(table.value(row, "ms")), 0.0);
            EXPECT_LE(*numberOf(table.value(row, "kept")), objects);
        }
        if (setting == 0) expectWhole(experiment, table);
    }
}

TEST(Benchmarks, frustumTestsHaveEveryPointOnce) {
    const Experiment experiment = frustumTests(10'000'000);
    std::vector<Row> points;
    for (const Setting& setting : experiment.settings) {
        EXPECT_THAT(points, testing::Not(testing::Contains(setting.labels)));
        points.push_back(setting.labels);
    }
    // Five counts of boxes and of spheres with four shares each, and four counts around a constant visible set.
    EXPECT_EQ(points.size(), 5u * 2 * 4 + 4);
}

TEST(Benchmarks, mapsGrow) {
    const Experiment experiment = sphericalMapsGrowth();
    Experiment two = experiment;
    two.settings.resize(2);
    const ResultTable table = run(two);
    expectWhole(two, table);
    ASSERT_EQ(table.rows.size(), 2u);
    ASSERT_EQ(table.plots.size(), 2u);
    EXPECT_EQ(table.plots[0].lines.size(), 4u);
    EXPECT_EQ(table.plots[0].lines[1].name, "sphere: centroid map");
    ASSERT_TRUE(table.checks[0].value);
    EXPECT_NEAR(*table.checks[0].value, 1.0, 0.1) << "bytes by faces";
}

TEST(Benchmarks, losslessIsBuiltBesideEmbree) {
    const Experiment experiment = losslessBuild({"sphere:triangles=2000"}, 1);
    const ResultTable table = run(experiment);
    expectWhole(experiment, table);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.triangles, 2000u);
    const auto ratio = std::get<RatioEstimate>(table.value(0, "to_embree"));
    EXPECT_GT(ratio.ratio, 0.0);
    EXPECT_LE(ratio.ci95[0], ratio.ratio);
    ASSERT_EQ(table.plots.size(), 1u);
    EXPECT_EQ(table.plots[0].lines.size(), 4u) << "two builders, their medians and their best";
}

TEST(Benchmarks, losslessGrows) {
    const Experiment experiment = losslessGrowth();
    const ResultTable table = runOne(experiment, 0);
    expectWhole(experiment, table);
    EXPECT_EQ(table.plots.size(), 2u);
    EXPECT_FALSE(table.checks[0].value) << "one point has no exponent";
    EXPECT_FALSE(table.checkFailed());
}

TEST(Benchmarks, losslessCulls) {
    Experiment experiment =
        losslessCull({.views = 1, .repetitions = 1, .picture = {64, 48}, .large = {96, 64}, .camerasBy = 2'000});
    experiment.settings.resize(5);
    const ResultTable table = run(experiment);
    expectWhole(experiment, table);
    EXPECT_EQ(table.rows.size(), 5u * 5) << "five paths and configurations";
    EXPECT_EQ(table.plots.size(), 2u * 5);
    EXPECT_EQ(table.plots[0].lines.size(), 5u + 2) << "five configurations and two powers";
    for (size_t row = 0; row < table.rows.size(); ++row) {
        EXPECT_EQ(*numberOf(table.value(row, "missed_pixels")), 0.0) << "the timed frames are judged";
        EXPECT_GT(std::get<RatioEstimate>(table.value(row, "ratio_to_backface")).ratio, 0.0);
    }
    EXPECT_THAT(table.brokenPromises, testing::IsEmpty());
}

TEST(Benchmarks, layoutsAreDrawnInTurns) {
    const Experiment experiment = losslessLayouts({"sphere:triangles=500"}, 2);
    EXPECT_TRUE(experiment.needsOpenGl());
    const ResultTable table = run(experiment, 1);
    expectWhole(experiment, table);
    EXPECT_EQ(table.rows.size(), 4u * 2 * 5);
    EXPECT_FALSE(table.gl.renderer.empty());
    ASSERT_EQ(table.plots.size(), 1u);
    EXPECT_TRUE(table.plots[0].title.starts_with("sphere, front: ")) << table.plots[0].title;
    EXPECT_EQ(table.plots[0].lines.size(), 2u * 4) << "two layouts on four paths";
    for (size_t row = 0; row < table.rows.size(); ++row) EXPECT_EQ(*numberOf(table.value(row, "missed_pixels")), 0.0);
}

TEST(Benchmarks, softwarePicturesAreTimedBesideOpenGls) {
    Experiment experiment = softwareRaster({"sphere:triangles=500", "sphere:triangles=80"}, "orbit:2");
    for (Setting& setting : experiment.settings) setting.size = {64, 48};
    const ResultTable table = run(experiment, 2);
    expectWhole(experiment, table);
    ASSERT_EQ(table.rows.size(), 2u * 4);
    const auto ratio = std::get<RatioEstimate>(table.value(2, "picture_ratio"));
    EXPECT_GT(ratio.ratio, 0.0);
    EXPECT_LT(ratio.ci95[0], ratio.ci95[1]) << "the interval of two views is not a point";
    ASSERT_EQ(table.plots.size(), 1u);
    ASSERT_EQ(table.plots[0].lines.size(), 4u + 2) << "frames, and two pictures made in software";
    EXPECT_LT(table.plots[0].lines[0].points[0].x, table.plots[0].lines[0].points[1].x);
    EXPECT_LT(*numberOf(table.value(3, "comparisons")), *numberOf(table.value(2, "comparisons")));
    for (const size_t own : {2u, 3u, 6u, 7u}) EXPECT_EQ(*numberOf(table.value(own, "differing_pixels")), 0.0) << "row " << own;
    ResultTable wrong = table;
    wrong.rows[7].back() = 0.002;
    EXPECT_FALSE(checked(experiment.checks, wrong).at(1).holds()) << "another picture than OpenGL's";
}

TEST(Benchmarks, octreeQueryTakesTurnsWithBackface) {
    const Experiment experiment = octreeQueryBesideBackface(
        "layers:count=8,triangles=200", {"split:mesh=knot:triangles=2000,by=clusters,triangles=100"}, {96, 64});
    EXPECT_TRUE(experiment.needsOpenGl());
    const ResultTable table = run(experiment, 2);
    expectWhole(experiment, table);
    ASSERT_EQ(table.rows.size(), 2u * 7);
    ASSERT_EQ(table.plots.size(), 1u);
    EXPECT_EQ(table.plots[0].lines.size(), 7u);
    ASSERT_EQ(table.checks.size(), 2u);
    EXPECT_TRUE(table.checks[1].holds()) << "nothing is lost";
    EXPECT_THAT(table.brokenPromises, testing::IsEmpty());
}

/// The keys in a CSV's first line; the ends of an interval belong to the column before them.
std::vector<std::string> keysOf(std::istream& csv) {
    std::string line, key;
    std::getline(csv, line);
    std::vector<std::string> keys;
    for (std::istringstream in(line); std::getline(in, key, ',');)
        if (!key.ends_with("_low") && !key.ends_with("_high")) keys.push_back(key);
    return keys;
}

TEST(KeptRuns, haveTheColumnsOfTheirExperimentsOrThoseThatTheDocsSay) {
    struct Kept {
        Experiment experiment;
        std::vector<std::string> lacks{}, has{};  ///< beside today's columns
    };
    const std::vector<Kept> kept{
        {sphericalMapsGrowth()},
        {losslessGrowth()},
        {losslessCull(), {"missed_pixels", "ratio_to_backface"}},
        {octreeQueryBesideBackface("layers:count=2,triangles=8", {})},
        {softwareRaster({"bunny"}, "case-2")},
        {lectureTable()},
        {frustumTests(1000), {"in_view"}},
        {losslessLayouts({"bunny"}), {"scene", "ratio_to_backface", "missed_pixels"}, {"frame_to_backface"}}};
    for (const auto& [experiment, lacks, has] : kept) {
        std::ifstream file(std::filesystem::path(CULLSCOPE_SOURCE_DIR) / "tests" / "benchmark" / (experiment.id + ".csv"));
        ASSERT_TRUE(file.is_open()) << experiment.id;
        std::istringstream now(rowsCsv(emptyTable(experiment)));
        std::vector<std::string> expected = keysOf(now);
        std::erase_if(expected,
                      [&lacks = lacks](const std::string& key) { return std::ranges::find(lacks, key) != lacks.end(); });
        expected.insert(expected.end(), has.begin(), has.end());
        EXPECT_THAT(keysOf(file), testing::UnorderedElementsAreArray(expected)) << experiment.id;
    }
}

}  // namespace
}  // namespace cullscope::benchmark::benchmark_test
