// The experiments of the statistics page: core's driver and columns, measured between the window's pictures.

#include "ui/jobs/scene_experiment.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QTest>

#include "core/experiments/sweeps.h"
#include "tests/support/small_experiment.h"
#include "ui/statistics/result_table_model.h"

namespace cullscope::ui::scene_experiment_test {
namespace {

constexpr int kPatience = 60'000;  // ms

bool waitUntil(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

/// Two sweeps that cross at the defaults of `spherical`, beside `frustum` and the baselines.
Experiment sweeps(const std::string& path) {
    Experiment experiment =
        sweepExperiment({{"spherical", "rows", {"90", "180"}}, {"spherical", "band", {"5", "20"}}}, {"frustum"});
    Setting& setting = experiment.settings.front();
    setting.views = [path](const Scene& scene) { return cameraPath(path, scene); };
    setting.size = {64, 48};
    setting.baselinesToo = true;
    return experiment;
}

/// What a run said, in its order.
class Page : public testing::Test {
protected:
    Page() {
        QObject::connect(&running, &SceneExperiment::measured, [this](const ResultTable& table, const MeasureResult& result) {
            tables.push_back(table);
            results.push_back(result);
        });
        QObject::connect(&running, &SceneExperiment::failed, [this](const Message& message) { failures.push_back(message); });
        QObject::connect(&running, &SceneExperiment::ended, [this] { ++ends; });
    }
    [[nodiscard]] bool complete() const { return !results.empty() && !results.back().interrupted; }

    ScenePointer scene = test::smallExperiment({}).scene;
    GpuThread gpu;
    SceneExperiment running{&gpu, std::make_shared<StructureStore>()};
    std::vector<ResultTable> tables;
    std::vector<MeasureResult> results;
    std::vector<Message> failures;
    int ends = 0;
};

TEST_F(Page, tablesHaveTheColumnsRowsAndPlotsOfTheExperimentWhileItRunsAndAtItsEnd) {
    const Experiment experiment = sweeps("walk:300");
    running.start(experiment, scene, 1);
    EXPECT_TRUE(running.running());
    ASSERT_TRUE(waitUntil([this] { return complete(); })) << (failures.empty() ? "" : failures.front().english());
    EXPECT_FALSE(running.running());
    EXPECT_EQ(ends, 1);
    EXPECT_GT(tables.size(), 1u) << "some before the end";
    for (size_t i = 0; i < tables.size(); ++i) {
        ResultTable expected = emptyTable(experiment);
        addRuns(expected, experiment, experiment.settings.front(), results[i]);
        EXPECT_EQ(tableCsv(tables[i]), tableCsv(expected)) << i;
        EXPECT_EQ(tables[i].interrupted, i + 1 < tables.size());
        EXPECT_EQ(tables[i].rows.size(), 4u + 1u + 2u) << "two sweeps of two values, frustum, the baselines";
    }
    EXPECT_EQ(tables.back().experiment, "sweep");
    EXPECT_EQ(tables.back().plots.size(), 1u);
}

TEST_F(Page, rowsOfThePageAreThoseOfTheTableEachStrategyOnce) {
    running.start(sweeps("walk:2"), scene, 1);
    ASSERT_TRUE(waitUntil([this] { return complete(); }));
    const ResultTable& table = tables.back();
    const std::vector<ResultRow> rows = resultRows(table);
    ASSERT_EQ(rows.size(), 3u + 1u + 2u) << "the sweeps cross at rows=180, band=5";
    QStringList names;
    for (const ResultRow& row : rows) names << row.id;
    EXPECT_EQ(names.join(QLatin1Char(' ')), QStringLiteral("spherical spherical spherical frustum all backface"));
    const std::vector<ResultRow> ofRuns = resultRows(results.back());
    for (const ResultRow& row : rows) {
        const auto same = std::ranges::find(ofRuns, row.name, &ResultRow::name);
        ASSERT_NE(same, ofRuns.end()) << row.name.toStdString();
        for (int column = 0; column < ResultTableModel::columns(); ++column)
            EXPECT_EQ(ResultTableModel::value(row, column), ResultTableModel::value(*same, column)) << column;
    }
    // Where the experiment's table says something else, so does the page.
    ResultTable changed = table;
    for (size_t column = 0; column < changed.columns.size(); ++column)
        if (changed.columns[column].key == "fps_overall") changed.rows[0][column] = 1234.0;
    EXPECT_EQ(resultRows(changed)[0].fpsOverall, 1234.0);
}

TEST_F(Page, cancellingEndsAtOnceAndKeepsWhatWasMeasured) {
    running.start(sweeps("walk:5000"), scene, 1);
    ASSERT_TRUE(waitUntil([this] { return !tables.empty(); }));
    const double seen = *numberOf(tables.back().value(0, "poses"));
    const size_t before = tables.size();
    running.cancel();
    EXPECT_FALSE(running.running());
    EXPECT_EQ(ends, 1);
    ASSERT_TRUE(waitUntil([&] { return tables.size() > before; }));
    EXPECT_TRUE(tables.back().interrupted);
    EXPECT_GE(*numberOf(tables.back().value(0, "poses")), seen);
    EXPECT_LT(*numberOf(tables.back().value(0, "poses")), 5000.0);
    EXPECT_EQ(ends, 1);
}

TEST_F(Page, aNewerRunTakesThePlaceOfAnOlder) {
    running.start(sweeps("walk:5000"), scene, 1);
    ASSERT_TRUE(waitUntil([this] { return !tables.empty(); }));
    tables.clear();
    results.clear();
    running.start(sweeps("orbit:3"), scene, 1);
    // The end is told after the last result.
    ASSERT_TRUE(waitUntil([this] { return complete() && ends > 0; }));
    for (const MeasureResult& result : results) EXPECT_EQ(result.request.path.name, "orbit:3") << "stale";
    EXPECT_EQ(ends, 1);
    running.start(sweeps("walk:5000"), scene, 1);
    running.cancel();
    EXPECT_EQ(ends, 2) << "before anything is measured";
}

TEST_F(Page, whatCannotBeMeasuredIsOneSentenceAndAnEnd) {
    Experiment experiment = sweeps("walk:2");
    experiment.settings.front().views = [](const Scene&) { return CameraPath(); };
    running.start(experiment, scene, 1);
    ASSERT_TRUE(waitUntil([this] { return ends > 0; }));
    ASSERT_EQ(failures.size(), 1u);
    EXPECT_EQ(failures.front().english(), "The camera path has no poses.");
    EXPECT_TRUE(tables.empty());
    QTest::qWait(100);
    EXPECT_EQ(ends, 1);
    EXPECT_FALSE(running.running());
}

}  // namespace
}  // namespace cullscope::ui::scene_experiment_test
