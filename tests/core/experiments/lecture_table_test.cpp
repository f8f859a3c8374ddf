#include "core/experiments/lecture_table.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/gl_environment.h"

namespace cullscope::test::lecture_table_test {
namespace {

LectureTableSize quick() {
    LectureTableSize size;
    size.overlaps = {1, 2, 8};
    size.surfaces = {10, 200};
    size.views = {1, 3};
    size.size = {64, 48};
    size.repetitions = 1;
    return size;
}

std::string words(const ResultTable& table, size_t row, const char* column) {
    const CellValue value = table.value(row, column);
    const auto* text = std::get_if<std::string>(&value);
    return text == nullptr ? std::string() : *text;
}

TEST(LectureTable, hasEveryMethodAtEverySetting) {
    const Experiment experiment = lectureTable(quick());
    EXPECT_TRUE(experiment.needsOpenGl());
    const ResultTable table = runExperiment(experiment, {});
    const size_t methods = lectureMethods().size();
    ASSERT_EQ(table.rows.size(), 3u * 2 * 2 * methods);
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const std::string method = words(table, row, "method");
        EXPECT_EQ(method, lectureMethods()[row % methods]);
        EXPECT_GT(*numberOf(table.value(row, "total_ms")), 0.0) << method;
        EXPECT_NEAR(*numberOf(table.value(row, "total_ms")),
                    *numberOf(table.value(row, "build_ms")) + *numberOf(table.value(row, "views_ms")), 1e-9);
        EXPECT_EQ(*numberOf(table.value(row, "missed_pixels")), 0.0) << method;
        EXPECT_GE(*numberOf(table.value(row, "triangles")), 2.0 * *numberOf(table.value(row, "overlap")));
    }
    ASSERT_EQ(table.plots.size(), 3u);
    for (const LinePlot& plot : table.plots) EXPECT_GE(plot.lines.size(), 3u) << plot.title;
    EXPECT_FALSE(table.gl.renderer.empty());
    EXPECT_THAT(table.brokenPromises, testing::IsEmpty());
}

/// What the one meter measured for the table, by setting.
struct Measured {
    std::vector<MeasureResult> results;
    size_t uploads = 0, built = 0;
};
Measured measuredOf(const Experiment& experiment, int repetitions) {
    Measured measured;
    MeasuredScene shared;
    ExperimentStage stage;
    stage.measure = [&](const MeasureRequest& request, const Progress& progress) {
        measured.results.push_back(measure(request, progress, {}, &shared));
        return measured.results.back();
    };
    (void)runExperiment(experiment, {{}, repetitions}, {}, {}, stage);
    measured.uploads = shared.uploads();
    measured.built = shared.built();
    return measured;
}

TEST(LectureTable, everyTimedFrameIsJudgedAndASceneIsUploadedAndBuiltOnce) {
    LectureTableSize size = quick();
    size.overlaps = {2};
    const Measured measured = measuredOf(lectureTable(size), 0);
    ASSERT_EQ(measured.results.size(), 4u) << "two scenes, each seen once and three times";
    for (size_t setting = 0; setting < 4; ++setting)
        for (const RunMeasurement& run : measured.results[setting].runs) {
            ASSERT_EQ(run.frames.size(), setting % 2 == 0 ? 1u : 3u) << run.strategy.id;
            for (const FrameMeasurement& frame : run.frames) EXPECT_TRUE(frame.accuracy.has_value()) << run.strategy.id;
        }
    EXPECT_EQ(measured.uploads, 2u);
    EXPECT_EQ(measured.built, 2 * lectureMethods().size());
}

TEST(LectureTable, repetitionsAreThoseThatTheUserStates) {
    LectureTableSize size = quick();
    size.overlaps = {2};
    size.surfaces = {10};
    size.repetitions = 4;
    const auto repetitions = [&](int stated) {
        std::vector<int> counts;
        for (const MeasureResult& result : measuredOf(lectureTable(size), stated).results)
            counts.push_back(result.runs.front().frames.back().repetitions);
        return counts;
    };
    EXPECT_EQ(repetitions(0), (std::vector<int>{4, 1})) << "a single view, and many";
    EXPECT_EQ(repetitions(2), (std::vector<int>{2, 2}));
}

TEST(LectureTable, lossesOfAnyViewAreInTheRow) {
    LectureTableSize size = quick();
    size.overlaps = {2};
    size.surfaces = {10};
    size.views = {3};
    const Experiment experiment = lectureTable(size);
    MeasureResult result = measuredOf(experiment, 0).results.front();
    for (RunMeasurement& run : result.runs)
        if (run.strategy.id == "octree-query") run.frames[2].accuracy->missedPixels = 17;
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, experiment.settings.front(), result);
    for (size_t row = 0; row < table.rows.size(); ++row)
        EXPECT_EQ(*numberOf(table.value(row, "missed_pixels")), words(table, row, "method") == "octree-query" ? 17.0 : 0.0);
    result.interrupted = true;
    addRuns(table = emptyTable(experiment), experiment, experiment.settings.front(), result);
    EXPECT_TRUE(table.rows.empty()) << "sums over some of the views";
}

TEST(LectureTable, methodThatRefusesAViewOrASceneSaysWhyAndTheOthersGoOn) {
    LectureTableSize size = quick();
    size.overlaps = {2};
    size.surfaces = {200};
    size.views = {3};
    Experiment experiment = lectureTable(size);
    for (std::string& strategy : experiment.settings.front().strategies)
        if (strategy == "bsp" || strategy == "painter") strategy += ":limit=2";
    const ResultTable table = runExperiment(experiment, {});
    ASSERT_EQ(table.rows.size(), lectureMethods().size());
    for (size_t row = 0; row < table.rows.size(); ++row) {
        const std::string method = words(table, row, "method");
        if (method == "bsp" || method == "painter")
            EXPECT_THAT(words(table, row, "total_ms"), testing::HasSubstr("limit")) << method;
        else
            EXPECT_GT(numberOf(table.value(row, "total_ms")).value_or(0.0), 0.0) << method;
    }
}

/// The verdict of the lecture on a method.
std::string verdictOn(const char* method, int overlap, int surfaces, int views) {
    LectureTableSize size = quick();
    size.overlaps = {overlap};
    size.surfaces = {surfaces};
    size.views = {views};
    const ResultTable table = runExperiment(lectureTable(size), {});
    for (size_t row = 0; row < table.rows.size(); ++row)
        if (words(table, row, "method") == method) return words(table, row, "lecture");
    return "no row";
}

TEST(LectureTable, statesTheLecturesVerdicts) {
    EXPECT_EQ(verdictOn("painter", 1, 10, 1), "very little overlap, few surfaces");
    EXPECT_EQ(verdictOn("bsp", 1, 10, 100), "very little overlap, few surfaces, many views");
    EXPECT_EQ(verdictOn("scan-line", 2, 100, 1), "little overlap");
    EXPECT_EQ(verdictOn("painter", 2, 100, 1), "");
    EXPECT_EQ(verdictOn("octree-query", 8, 1000, 1), "");
    EXPECT_EQ(verdictOn("all", 1, 10, 1), "") << "the GPU's depth buffer has none";
}

TEST(LectureTable, verdictsAreOnlyWhereTheLectureOrTheMeasurementSaysSomething) {
    LectureTableSize size = quick();
    size.overlaps = {8};
    size.surfaces = {200};
    size.views = {1};
    const ResultTable silent = runExperiment(lectureTable(size), {});
    for (size_t row = 0; row < silent.rows.size(); ++row) EXPECT_EQ(words(silent, row, "agreement"), "");
    size.overlaps = {1};
    const ResultTable spoken = runExperiment(lectureTable(size), {});
    for (size_t row = 0; row < spoken.rows.size(); ++row) {
        if (words(spoken, row, "lecture").empty()) continue;
        EXPECT_THAT(words(spoken, row, "agreement"), testing::AnyOf("agrees", "disagrees: slower"));
    }
}

/// The bytes of a method at one layer seen once.
double bytesOf(const char* method, int surfaces) {
    LectureTableSize size = quick();
    size.overlaps = {1};
    size.surfaces = {surfaces};
    size.views = {1};
    const ResultTable table = runExperiment(lectureTable(size), {});
    for (size_t row = 0; row < table.rows.size(); ++row)
        if (words(table, row, "method") == method) return numberOf(table.value(row, "bytes")).value_or(-1.0);
    return -1.0;
}

TEST(LectureTable, bytesCountTheBuffersAndTablesOfAFrame) {
    const double pixels = 64 * 48, perTriangle = 8;
    for (const char* method : {"depth-buffer", "scan-line"}) {
        // Depth and triangle number of each pixel, and the vertices and bins of the triangles.
        const double few = bytesOf(method, 10), many = bytesOf(method, 2000);
        EXPECT_GE(few, 8 * pixels) << method;
        EXPECT_GE(many - few, perTriangle * 1500) << method;
    }
    EXPECT_GT(bytesOf("scan-line", 2000), bytesOf("depth-buffer", 2000)) << "the edge table and the active edges";
    for (const char* method : {"painter", "bsp"}) {
        // Triangles in order: three positions and three normals.
        EXPECT_GE(bytesOf(method, 2000) - bytesOf(method, 10), 72 * 1500) << method;
    }
    EXPECT_EQ(bytesOf("all", 10), bytesOf("all", 2000)) << "the GPU's depth buffer and the list of objects";
}

TEST(LectureTable, methodThatTakesTooLongSaysSo) {
    LectureTableSize size = quick();
    size.overlaps = {2};
    size.surfaces = {200};
    size.views = {40};
    size.secondsOfAMethod = 0.0;
    const ResultTable table = runExperiment(lectureTable(size), {});
    for (size_t row = 0; row < table.rows.size(); ++row) {
        EXPECT_THAT(words(table, row, "total_ms"), testing::HasSubstr("1 of 40 views"));
    }
}

TEST(LectureTable, endsWhenItIsStopped) {
    std::stop_source stop;
    stop.request_stop();
    const ResultTable table = runExperiment(lectureTable(quick()), {}, {nullptr, stop.get_token()});
    EXPECT_TRUE(table.interrupted);
    EXPECT_TRUE(table.rows.empty());
}

}  // namespace
}  // namespace cullscope::test::lecture_table_test
