#include "ui/statistics/history_file.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>

#include "core/base/error.h"
#include "core/geometry/random.h"

namespace cullscope::ui::history_file_test {
namespace {

std::vector<PastExperiment> someExperiments(Random& random) {
    std::vector<PastExperiment> experiments(size_t(random.between(0, 6)));
    for (PastExperiment& experiment : experiments) {
        experiment.scene = QStringLiteral("성 \"castle\" %1").arg(random.bits() % 100);
        experiment.what = QStringLiteral("tour:16, 640 × 480");
        experiment.when = QDateTime::fromMSecsSinceEpoch(qint64(random.between(1e12, 2e12)));
        experiment.rows.resize(size_t(random.between(0, 4)));
        for (ResultRow& row : experiment.rows) {
            row.name = QStringLiteral("절두체 컬링");
            row.id = QStringLiteral("frustum");
            row.baseline = "all";
            const double ratio = random.between(0.1, 30.0);
            if (random.unit() < 0.7)
                row.speedup = random.unit() < 0.5 ? RatioEstimate{ratio, {0.9 * ratio, 1.2 * ratio}, true}
                                                  : RatioEstimate{ratio, {2.0 * ratio, 2.0 * ratio}, false};
            if (random.unit() < 0.7) row.missedPpm = random.between(0.0, 1e6);
        }
    }
    return experiments;
}

TEST(HistoryFile, whatAHistoryShowsComesBackAsItWas) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("new/experiments.json")).toStdString();
    EXPECT_TRUE(readHistory(file).empty()) << "there is none at first";
    Random random(7);
    for (int round = 0; round < 50; ++round) {
        const std::vector<PastExperiment> written = someExperiments(random);
        writeHistory(file, written);
        const std::vector<PastExperiment> read = readHistory(file);
        ASSERT_EQ(read.size(), written.size());
        for (size_t i = 0; i < read.size(); ++i) {
            EXPECT_EQ(read[i].scene, written[i].scene);
            EXPECT_EQ(read[i].what, written[i].what);
            EXPECT_EQ(read[i].when.toMSecsSinceEpoch(), written[i].when.toMSecsSinceEpoch());
            ASSERT_EQ(read[i].rows.size(), written[i].rows.size());
            for (size_t row = 0; row < read[i].rows.size(); ++row) {
                EXPECT_EQ(read[i].rows[row].name, written[i].rows[row].name);
                EXPECT_EQ(read[i].rows[row].id, written[i].rows[row].id);
                EXPECT_EQ(read[i].rows[row].baseline, written[i].rows[row].baseline);
                EXPECT_EQ(read[i].rows[row].speedup, written[i].rows[row].speedup);
                EXPECT_EQ(read[i].rows[row].missedPpm, written[i].rows[row].missedPpm);
            }
        }
    }
}

TEST(HistoryFile, everyTruncationAndOtherFilesAreRefusedInASentence) {
    const QTemporaryDir folder;
    const std::filesystem::path file = folder.filePath(QStringLiteral("experiments.json")).toStdString();
    Random random(8);
    std::vector<PastExperiment> experiments = someExperiments(random);
    while (experiments.empty() || experiments.front().rows.empty()) experiments = someExperiments(random);
    writeHistory(file, experiments);
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::vector<std::string> wrong{"{}", "[]", R"({"format": "cullscope session", "experiments": []})",
                                   R"({"format": "cullscope history", "experiments": [{"scene": 3}]})"};
    for (size_t length = 0; length + 2 < text.size(); length += 7) wrong.push_back(text.substr(0, length));
    for (const std::string& each : wrong) {
        std::ofstream(file, std::ios::binary) << each;
        try {
            (void)readHistory(file);
            ADD_FAILURE() << "taken: " << each;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Input);
            EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
        }
    }
}

}  // namespace
}  // namespace cullscope::ui::history_file_test
