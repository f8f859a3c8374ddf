#include "core/experiments/experiment_list.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/base/error.h"
#include "core/experiments/han_hong_tables.h"
#include "core/measure/accuracy.h"
#include "core/measure/statistics.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"
#include "tests/support/table_cells.h"

namespace cullscope::test::paper_tables_test {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<double>;

size_t columnOf(const ResultTable& table, const std::string& key) {
    for (size_t i = 0; i < table.columns.size(); ++i)
        if (table.columns[i].key == key) return i;
    ADD_FAILURE() << table.experiment << " has no column " << key;
    return 0;
}

/// The values that the paper states in a column for one strategy, by setting.
Numbers stated(const std::string& experiment, const std::string& strategy, const std::string& key) {
    Numbers numbers;
    for (const Setting& setting : findExperiment(experiment).settings)
        numbers.push_back(std::get<double>(setting.stated.at(strategy).at(key)));
    return numbers;
}

FrameMeasurement frame(size_t pose, uint64_t considered, uint64_t missed, uint64_t hole, int caseNumber) {
    FrameMeasurement measured;
    measured.pose = pose;
    measured.consideredTriangles = considered;
    if (caseNumber > 0) measured.figures.push_back({"case", double(caseNumber)});
    measured.accuracy = Accuracy{};
    measured.accuracy->missedPixels = missed;
    measured.accuracy->coveredPixels = 1000;
    measured.accuracy->largestHolePixels = hole;
    return measured;
}

/// A made-up result: two runs over three poses; the second one loses pixels.
MeasureResult madeUp() {
    MeasureResult result;
    result.request = smallExperiment({"all", "frustum"});
    result.gl.renderer = "made up";
    RunMeasurement all, frustum;
    all.strategy = request("all");
    for (size_t pose = 0; pose < 3; ++pose) all.frames.push_back(frame(pose, 144'046, 0, 0, 0));
    all.summary.fpsMean = 100.0;
    frustum.strategy = request("frustum");
    frustum.frames = {frame(0, 100, 2, 2, 1), frame(1, 200, 30, 7, 1), frame(2, 600, 0, 0, 3)};
    frustum.summary.fpsMean = 250.0;
    frustum.summary.fpsMin = 200.0;
    frustum.summary.fpsMax = 300.0;
    frustum.summary.ratioToTriangles = {2.5, {2.0, 3.0}};
    frustum.summary.ratioToFrontFaces = {1.25, {1.0, 1.5}};
    frustum.summary.missedPixelRate = 32.0 / 3000.0;
    result.runs = {all, frustum};
    return result;
}

/// A setting of Table 2 whose proposed strategy is `frustum`.
Setting settingWithFrustum() {
    Setting setting = findExperiment("table-2").settings[1];
    setting.stated["frustum"] = setting.stated["spherical"];
    return setting;
}

TEST(PaperTables, theirNumbersAreThoseInPrint) {
    // The paper does not state its lens: Table 2 is measured with four.
    const auto fourTimes = [](const Numbers& numbers) {
        Numbers result;
        for (int lens = 0; lens < 4; ++lens) result.insert(result.end(), numbers.begin(), numbers.end());
        return result;
    };
    // Of several windows each three cases are measured with one view and with different ones.
    const auto threeTwice = [](const Numbers& numbers) {
        Numbers result;
        for (size_t i = 0; i < numbers.size(); i += 3)
            for (int views = 0; views < 2; ++views)
                result.insert(result.end(), numbers.begin() + std::ptrdiff_t(i), numbers.begin() + std::ptrdiff_t(i) + 3);
        return result;
    };
    EXPECT_EQ(stated("table-2", "all", "paper_faces"), fourTimes({144078, 144078, 144078}));
    EXPECT_EQ(stated("table-2", "spherical", "paper_faces"), fourTimes({13508, 16434, 26308}));
    EXPECT_EQ(stated("table-2", "all", "paper_fps"), fourTimes({295, 300, 295}));
    EXPECT_EQ(stated("table-2", "spherical", "paper_fps"), fourTimes({486, 432, 389}));
    EXPECT_EQ(stated("table-3", "all", "paper_fps"), threeTwice({80, 84, 80, 63, 65, 63}));
    EXPECT_EQ(stated("table-3", "spherical", "paper_fps"), threeTwice({376, 421, 202, 153, 174, 136}));
    EXPECT_EQ(stated("table-4", "all", "paper_fps"), threeTwice({70, 70, 71, 21, 21, 21}));
    EXPECT_EQ(stated("table-4", "spherical", "paper_fps"), threeTwice({206, 286, 161, 95, 32, 75}));
    EXPECT_EQ(stated("table-5", "all", "paper_fps_mean"), (Numbers{134, 700}));
    EXPECT_EQ(stated("table-5", "spherical", "paper_fps_max"), (Numbers{199, 828}));
    EXPECT_EQ(stated("table-5", "spherical", "paper_fps_min"), (Numbers{137, 738}));
    EXPECT_EQ(stated("table-5", "spherical", "paper_fps_mean"), (Numbers{170, 780}));
}

TEST(PaperTables, theirRatioIsProposedOverAll) {
    for (const char* id : {"table-2", "table-3", "table-4"}) {
        const Numbers all = stated(id, "all", "paper_fps"), proposed = stated(id, "spherical", "paper_fps");
        const Numbers ratios = stated(id, "spherical", "paper_speedup_vs_all");
        for (size_t i = 0; i < ratios.size(); ++i) EXPECT_DOUBLE_EQ(ratios[i], proposed[i] / all[i]) << id << " " << i;
    }
    EXPECT_DOUBLE_EQ(stated("table-5", "spherical", "paper_speedup_vs_all")[1], 780.0 / 700.0);
}

TEST(PaperTables, settingsAreThePapers) {
    using Setup = std::tuple<std::string, int, int, Upload>;
    const auto setupsOf = [](const std::string& id) {
        std::vector<Setup> setups;
        for (const Setting& s : findExperiment(id).settings) setups.emplace_back(s.path, s.size.width, s.windows, s.upload);
        return setups;
    };
    const Upload vbo = Upload::Vbo;
    const auto cases = [vbo](const char* field, int width, int windows) {
        std::vector<Setup> setups;
        for (const char* number : {"1", "2", "3"})
            setups.emplace_back(std::string("considered-") + number + ", " + field + "°", width, windows, vbo);
        return setups;
    };
    const auto both = [](std::vector<Setup> first, const std::vector<Setup>& second) {
        first.insert(first.end(), second.begin(), second.end());
        return first;
    };
    EXPECT_EQ(setupsOf("table-2"),
              both(both(cases("10", 320, 1), cases("35", 320, 1)), both(cases("50", 320, 1), cases("65", 320, 1))));
    const auto twice = [&](const std::vector<Setup>& setups) { return both(setups, setups); };
    EXPECT_EQ(setupsOf("table-3"), both(twice(cases("10", 320, 4)), twice(cases("10", 640, 4))));
    EXPECT_EQ(setupsOf("table-4"), both(twice(cases("10", 320, 4)), twice(cases("10", 320, 8))));
    for (const char* id : {"table-3", "table-4"})
        for (size_t i = 0; i < findExperiment(id).settings.size(); ++i)
            EXPECT_EQ(findExperiment(id).settings[i].differentViews, i / 3 % 2 == 1) << id << " " << i;
    EXPECT_EQ(setupsOf("table-5"),
              (std::vector<Setup>{{"fibonacci:12", 640, 1, Upload::VertexArray}, {"fibonacci:12", 640, 1, vbo}}));
    for (const Experiment& experiment : hanHongTables())
        for (const Setting& setting : experiment.settings) {
            EXPECT_EQ(setting.scene, "mesh:bunny,triangles=144046");
            if (!setting.timed()) continue;
            EXPECT_THAT(setting.strategies, testing::IsSupersetOf({"all", "backface", "spherical"}));
            EXPECT_THAT(setting.strategies, testing::Contains(setting.shown));
        }
}

TEST(PaperTables, viewsOfTable5KeepTheObjectInTheFrustum) {
    const MeasureRequest small = smallExperiment({"all"});
    const Setting& setting = findExperiment("table-5").settings[0];
    const CameraPath path = cameraPath(setting.path, *small.scene);
    EXPECT_GE(path.poses.size(), 10u);
    const Sphere& sphere = small.scene->boundingSphere();
    for (size_t pose = 0; pose < path.poses.size(); ++pose) {
        const View view(path.camera(pose), setting.size);
        EXPECT_EQ(classify(view.frustum(), Sphere{sphere.centre - view.eye(), sphere.radius}), Containment::Inside) << pose;
    }
}

TEST(PaperTables, columnsHaveKeysOfTheirOwnThatHoldEveryCell) {
    for (const Experiment& experiment : knownExperiments()) {
        std::set<std::string> keys;
        for (const ResultColumn& column : experiment.columns) EXPECT_TRUE(keys.insert(column.key).second) << column.key;
        for (const Setting& setting : experiment.settings)
            for (const auto& [strategy, cells] : setting.stated)
                for (const auto& [key, value] : cells) EXPECT_TRUE(keys.contains(key)) << experiment.id << " loses " << key;
    }
}

TEST(PaperTables, rowsAreWhatWasMeasured) {
    const Experiment& experiment = findExperiment("table-2");
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, settingWithFrustum(), madeUp());
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(std::get<std::string>(valueOf(table, 1, "strategy")), "frustum");
    EXPECT_EQ(number(table, 0, "case"), 2.0);
    EXPECT_EQ(number(table, 0, "paper_faces"), 144078.0);
    EXPECT_EQ(number(table, 1, "paper_faces"), 16434.0);
    EXPECT_DOUBLE_EQ(number(table, 1, "paper_speedup_vs_all"), 432.0 / 300.0);
    EXPECT_DOUBLE_EQ(number(table, 1, "considered_triangles"), 300.0);
    EXPECT_EQ(std::get<std::string>(valueOf(table, 1, "cases")), "1 ×2, 3 ×1");
    EXPECT_TRUE(std::holds_alternative<std::monostate>(valueOf(table, 0, "cases")));
    EXPECT_EQ(number(table, 1, "poses"), 3.0);
    EXPECT_EQ(number(table, 1, "fps_min"), 200.0);
    EXPECT_EQ(number(table, 1, "fps_mean"), 250.0);
    EXPECT_EQ(number(table, 1, "fps_max"), 300.0);
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 1, "ratio_to_all")).ratio, 2.5);
    EXPECT_EQ(std::get<RatioEstimate>(valueOf(table, 1, "ratio_to_backface")).ci95, (std::array{1.0, 1.5}));
    EXPECT_EQ(number(table, 1, "missed_pixels"), 32.0);
    EXPECT_EQ(number(table, 1, "largest_hole_px"), 7.0);
    EXPECT_DOUBLE_EQ(number(table, 1, "missed_pixel_rate"), 32.0 / 3000.0);
    EXPECT_EQ(valueText(table.columns[columnOf(table, "ratio_to_all")], valueOf(table, 1, "ratio_to_all")), "2.50 [2.00, 3.00]");
    EXPECT_EQ(valueText(table.columns[columnOf(table, "missed_pixel_rate")], valueOf(table, 1, "missed_pixel_rate")), "10667");
}

TEST(PaperTables, brokenPromiseIsRecordedOnce) {
    const Experiment& experiment = findExperiment("table-2");
    ResultTable table = emptyTable(experiment);
    MeasureResult result = madeUp();
    addRuns(table, experiment, settingWithFrustum(), result);
    EXPECT_THAT(table.brokenPromises, testing::IsEmpty()) << "approximate strategies promise nothing";
    result.runs[1].promise = Promise::Conservative;
    addRuns(table, experiment, settingWithFrustum(), result);
    addRuns(table, experiment, settingWithFrustum(), result);
    EXPECT_THAT(table.brokenPromises, testing::ElementsAre("frustum"));
}

TEST(PaperTables, jsonHasThePapersAndOurNumbers) {
    const Experiment& experiment = findExperiment("table-2");
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, settingWithFrustum(), madeUp());
    const Json json = Json::parse(tablesJson({table}));
    EXPECT_EQ(json["machine"]["gl_renderer"], "made up");
    const Json& written = json["experiments"][0];
    EXPECT_EQ(written["experiment"], "table-2");
    EXPECT_EQ(written["scene"]["triangles"], madeUp().request.scene->triangleCount());
    EXPECT_FALSE(written["notes"].empty());
    const Json& row = written["rows"][1];
    EXPECT_EQ(row["paper_fps"], 432.0);
    EXPECT_EQ(row["fps_mean"], 250.0);
    EXPECT_EQ(row["ratio_to_all"], 2.5);
    EXPECT_EQ(row["ratio_to_all_ci95"], Json::array({2.0, 3.0}));
    EXPECT_TRUE(written["rows"][0]["cases"].is_null());
    for (const Json& column : written["columns"]) EXPECT_TRUE(row.contains(column["key"].get<std::string>())) << column;
}

TEST(PaperTables, aRatioWithoutAnIntervalStandsAlone) {
    ResultTable table;
    table.columns = {{"ratio_to_all", "ratio", ResultColumn::Origin::Measured, 2}};
    table.addRow({{"ratio_to_all", RatioEstimate{2.0, {2.0, 2.0}, false}}});
    EXPECT_EQ(valueText(table.columns[0], table.value(0, "ratio_to_all")), "2.00");
    const Json row = Json::parse(tablesJson({table}))["experiments"][0]["rows"][0];
    EXPECT_TRUE(row["ratio_to_all_ci95"].is_null());
    EXPECT_EQ(rowsCsv(table), "ratio_to_all,ratio_to_all_low,ratio_to_all_high\n2,,\n");
}

TEST(ResultTables, wordsWithQuotationMarksAreOneCellOfCsv) {
    ResultTable table;
    table.columns = {{"mesh", "mesh"}, {"triangles", "triangles"}};
    table.addRow({{"mesh", std::string("bunny, \"the\" one")}, {"triangles", 12.0}});
    EXPECT_EQ(rowsCsv(table), "mesh,triangles\n\"bunny, \"\"the\"\" one\",12\n");
}

TEST(PaperTables, csvRowsAreOfOneLength) {
    const Experiment& experiment = findExperiment("table-2");
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, settingWithFrustum(), madeUp());
    std::istringstream csv(tableCsv(table));
    std::vector<std::string> lines;
    for (std::string line; std::getline(csv, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_THAT(lines[0], testing::HasSubstr("ratio_to_all,ratio_to_all_low,ratio_to_all_high"));
    EXPECT_THAT(lines[2], testing::HasSubstr("2.5,2,3"));
    EXPECT_THAT(lines[2], testing::HasSubstr("\"1 ×2, 3 ×1\""));
    const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    EXPECT_EQ(commas(lines[0]), commas(lines[1]));
    EXPECT_EQ(commas(lines[0]) + 1, commas(lines[2])) << "one comma is quoted";
}

TEST(PaperTables, refusalOfAnUnknownExperimentNamesTheKnownOnes) {
    try {
        (void)findExperiment("table-9");
        FAIL() << "found";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_STREQ(error.what(),
                     "There is no experiment \"table-9\". Known: table-1, table-2, table-3, table-4, table-5, "
                     "table-1-layouts, table-2-views, spherical-readings, spherical-domain, vfc-40-views, vfc-fitted-views, "
                     "lecture-table, quiz, example, "
                     "bsp-planes, plant-methods, plant-pipelines, plant-losses, occlusion-growth, occlusion-sizes.");
    }
}

}  // namespace
}  // namespace cullscope::test::paper_tables_test
