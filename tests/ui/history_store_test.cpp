#include "ui/statistics/history_store.h"

#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QTemporaryDir>
#include <fstream>

#include "core/base/error.h"
#include "core/experiments/store/recorder.h"
#include "tests/support/small_experiment.h"
#include "ui/statistics/comparison_dialog.h"
#include "ui/statistics/history_panel.h"

namespace cullscope::ui::history_store_test {
namespace {

/// As a desktop before there was a store wrote it.
constexpr const char* kOldHistory = R"({"format": "cullscope history", "version": 1, "experiments": [
 {"scene": "성 \"castle\" 7", "what": "tour:16 · 640 × 480", "when": "2026-10-01T10:00:00.250Z", "rows": [
  {"name": "frustum box=length", "strategy": "frustum", "baseline": "all", "ratio": 2.5, "ratio_ci95": [2.25, 2.75],
   "missed_ppm": 12.5},
  {"name": "all", "strategy": "all", "baseline": "all", "ratio": 1.0}]},
 {"scene": "empty", "what": "tour:16 · 640 × 480", "when": "2026-10-02T10:00:00.000Z", "rows": []}]})";

class HistoryStore : public testing::Test {
protected:
    [[nodiscard]] std::filesystem::path file(const char* name) const {
        return m_folder.filePath(QLatin1String(name)).toStdString();
    }
    void measureInto(const store::ResultStore&) const {
        const HeadlessContext gl;
        store::Recorder recorder(file("results"), {"desktop", ""});
        (void)store::measureInto(&recorder, test::smallExperiment({"frustum", "all"}));
        ASSERT_FALSE(recorder.failure());
    }

private:
    QTemporaryDir m_folder;
};

TEST_F(HistoryStore, olderHistoryMovesIntoTheStoreOnce) {
    std::ofstream(file("experiments.json")) << kOldHistory;
    const store::ResultStore opened(file("results"));
    takeOldHistory(file("experiments.json"), opened);
    EXPECT_FALSE(std::filesystem::exists(file("experiments.json"))) << "it is in the store alone";
    takeOldHistory(file("experiments.json"), opened);
    const std::vector<PastExperiment> past = pastExperiments(opened, 50);
    ASSERT_EQ(past.size(), 2u);
    EXPECT_EQ(past[0].scene, QStringLiteral("성 \"castle\" 7"));
    EXPECT_EQ(past[0].what, QStringLiteral("tour:16 · 640 × 480"));
    EXPECT_EQ(past[0].when, QDateTime::fromString(QStringLiteral("2026-10-01T10:00:00.250Z"), Qt::ISODateWithMs));
    ASSERT_EQ(past[0].rows.size(), 2u);
    EXPECT_EQ(past[0].rows[0].name, QStringLiteral("frustum box=length"));
    EXPECT_EQ(past[0].rows[0].speedup, (RatioEstimate{2.5, {2.25, 2.75}, true}));
    EXPECT_EQ(past[0].rows[0].missedPpm, 12.5);
    EXPECT_FALSE(past[0].rows[1].speedup->hasInterval);
    EXPECT_EQ(pastExperiments(opened, 1).front().scene, QStringLiteral("empty")) << "the newest";
}

TEST_F(HistoryStore, otherFileInPlaceOfTheOlderHistoryIsRefusedInASentence) {
    const store::ResultStore opened(file("results"));
    const std::string text = kOldHistory;
    std::vector<std::string> wrong{"{}", "[]", R"({"format": "cullscope session", "experiments": []})"};
    for (size_t length = 0; length + 1 < text.size(); length += 29) wrong.push_back(text.substr(0, length));
    for (const std::string& each : wrong) {
        std::ofstream(file("experiments.json")) << each;
        try {
            takeOldHistory(file("experiments.json"), opened);
            ADD_FAILURE() << "taken: " << each;
        } catch (const Error& error) {
            EXPECT_NE(std::string(error.what()).find("experiments.json"), std::string::npos);
        }
        EXPECT_TRUE(std::filesystem::exists(file("experiments.json"))) << "it is left as it is";
    }
    EXPECT_TRUE(opened.list().empty()) << "all or none of it";
}

TEST_F(HistoryStore, measurementsAreFilteredComparedAndShownWithTheirIntervals) {
    const store::ResultStore opened(file("results"));
    measureInto(opened);
    measureInto(opened);
    const std::vector<PastExperiment> past = pastExperiments(opened, 50);
    ASSERT_EQ(past.size(), 2u);
    HistoryModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::Fatal);
    HistoryPanel panel(model);
    model.setExperiments(past);
    const RatioEstimate ratio = opened.read(2).find("frustum")->run.summary.ratioToOwnRule;
    EXPECT_EQ(past[1].rows[0].speedup, ratio) << "what was kept at the end is what the frames give";
    panel.filter().setText(QStringLiteral("no such scene"));
    EXPECT_EQ(model.columnCount(), 0);
    panel.filter().setText(QStringLiteral("FRUSTUM"));
    EXPECT_EQ(model.columnCount(), 2);
    for (const int column : {0, 1})
        EXPECT_TRUE(model.headerData(column, Qt::Horizontal, Qt::DisplayRole)
                        .toString()
                        .startsWith(QStringLiteral("%1: ").arg(2 - column)))
            << "errors call a measurement by its number";
    EXPECT_FALSE(panel.compare().isEnabled());
    std::vector<qint64> two;
    QObject::connect(&panel, &HistoryPanel::compareRequested, &panel, [&](qint64 a, qint64 b) { two = {a, b}; });
    panel.table().selectAll();
    panel.compare().click();
    EXPECT_EQ(two, (std::vector<qint64>{1, 2})) << "the earlier one is A";

    ComparisonDialog dialog(opened.read(1), opened.read(2));
    ASSERT_EQ(dialog.table().rowCount(), 2);
    const std::vector<store::Compared> compared = store::compared(opened.read(1), opened.read(2));
    for (int row = 0; row < 2; ++row) {
        EXPECT_EQ(dialog.table().item(row, 0)->text().toStdString(), compared[size_t(row)].a);
        EXPECT_EQ(dialog.table().item(row, 4)->text().contains(QLatin1Char('[')), compared[size_t(row)].ratio.hasInterval);
        dialog.table().setCurrentCell(row, 0);
        ASSERT_EQ(dialog.plot().plot().lines.size(), 2u);
        EXPECT_EQ(dialog.plot().plot().lines[1].points.size(), compared[size_t(row)].poses);
    }
}

}  // namespace
}  // namespace cullscope::ui::history_store_test
