#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QFile>
#include <QLocale>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "tests/ui/made_up_result.h"
#include "ui/statistics/conclusion.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/statistics_panel.h"

namespace cullscope::ui::statistics_panel_test {
namespace {

constexpr int kPatience = 60'000;  // ms

/// A panel with a result for its scene, and the signals that it emitted.
class Panel : public ::testing::Test {
protected:
    Panel() {
        result = madeUpResult();
        panel.resize(926, 220);
        panel.setScene(result.request.scene, {"star:seed=7,triangles=500", {}});
        QObject::connect(&panel, &StatisticsPanel::failed,
                         [this](const Message& message) { failures.push_back(message.english()); });
        QObject::connect(&panel, &StatisticsPanel::exported, [this](const QString& path) { files << path; });
    }

    void showResult() {
        panel.setRunning(true);
        panel.setResult(tableOf(result), result);
        panel.setRunning(false);
        ASSERT_TRUE(QTest::qWaitFor([this] { return panel.model().rowCount() == 3; }, kPatience));
    }
    /// Exports to a file in the folder and returns its contents.
    QByteArray exported(StatisticsPanel::File file, const QString& name) {
        const QString path = folder.filePath(name);
        panel.exportTo(file, path.toStdString());
        EXPECT_TRUE(QTest::qWaitFor([this] { return !files.isEmpty() || !failures.empty(); }, kPatience));
        EXPECT_TRUE(failures.empty()) << failures.front();
        files.clear();
        QFile written(path);
        EXPECT_TRUE(written.open(QIODevice::ReadOnly));
        return written.readAll();
    }

    MeasureResult result;
    StatisticsPanel panel;
    QTemporaryDir folder;
    std::vector<std::string> failures;
    QStringList files;
};

TEST_F(Panel, axesOfThePlotAreNamedFromTheStartAndEachCanBeChosen) {
    showResult();
    size_t axes = 0;
    for (QComboBox* box : panel.findChildren<QComboBox*>()) {
        if (!box->accessibleName().startsWith(QStringLiteral("Figure "))) continue;
        ++axes;
        EXPECT_FALSE(box->currentText().isEmpty()) << box->accessibleName().toStdString();
        for (int i = 0; i < box->count(); ++i) {
            EXPECT_FALSE(box->itemData(i).toString().isEmpty()) << box->itemText(i).toStdString() << " is a figure of files";
            box->setCurrentIndex(i);
            emit box->activated(i);
        }
    }
    EXPECT_EQ(axes, 2u);
}

TEST_F(Panel, startAsksForTheChosenExperiment) {
    std::vector<ExperimentSettings> asked;
    QObject::connect(&panel, &StatisticsPanel::startRequested,
                     [&](const ExperimentSettings& settings) { asked.push_back(settings); });
    panel.bar().start();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].path, "walk:16") << "the default of a scene of many objects";
    EXPECT_FALSE(asked[0].poses.has_value()) << "it is made beside the window";
    EXPECT_EQ(asked[0].size, (Viewport{320, 240}));
    EXPECT_EQ(asked[0].repetitions, 0);
    panel.setRunning(true);
    panel.bar().start();
    EXPECT_EQ(asked.size(), 1u) << "one is under way";
    panel.setRunning(false);
    panel.setScene(nullptr);
    panel.bar().start();
    EXPECT_EQ(asked.size(), 1u) << "there is no scene";
}

TEST_F(Panel, pathFileIsChosenAndABadOneIsOneSentence) {
    std::vector<ExperimentSettings> asked;
    QObject::connect(&panel, &StatisticsPanel::startRequested,
                     [&](const ExperimentSettings& settings) { asked.push_back(settings); });
    panel.bar().openPath(folder.filePath(QStringLiteral("missing.json")));
    ASSERT_EQ(failures.size(), 1u);
    const std::string good = folder.filePath(QStringLiteral("good.json")).toStdString();
    writeCameraPath(good, cameraPath("orbit:5", *result.request.scene));
    panel.bar().openPath(QString::fromStdString(good));
    panel.bar().start();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].poses->poses.size(), 5u);
    EXPECT_EQ(asked[0].path, good);
    CameraPath recorded = cameraPath("orbit:2", *result.request.scene);
    recorded.name = "mine.json";
    panel.setRecordedPath(recorded);
    panel.bar().start();
    EXPECT_EQ(asked.back().path, good) << "what was chosen stays chosen";
}

TEST_F(Panel, resultOfAnotherSceneIsDropped) {
    MeasureResult other = madeUpResult();
    panel.setRunning(true);
    panel.setResult(tableOf(other), other);
    QTest::qWait(200);
    EXPECT_EQ(panel.model().rowCount(), 0);
    showResult();
    panel.setScene(other.request.scene);
    EXPECT_EQ(panel.model().rowCount(), 0) << "a result of the scene before";
}

TEST_F(Panel, tablesRefreshAtMostTenTimesASecond) {
    panel.setRunning(true);
    QTest::qWait(150);
    int refreshes = 0;
    QObject::connect(&panel.model(), &QAbstractItemModel::dataChanged, [&] { ++refreshes; });
    QObject::connect(&panel.model(), &QAbstractItemModel::modelReset, [&] { ++refreshes; });
    for (int i = 0; i < 50; ++i) panel.setResult(tableOf(result), result);
    EXPECT_EQ(refreshes, 1) << "the first at once, the rest later";
    ASSERT_TRUE(QTest::qWaitFor([&] { return refreshes == 2; }, kPatience)) << "the last is never left out";
}

TEST_F(Panel, csvAndJsonAreCores) {
    showResult();
    const QByteArray csv = exported(StatisticsPanel::File::Csv, QStringLiteral("r.csv"));
    EXPECT_EQ(csv.count('\n'), 1 + 3 * 4);
    const nlohmann::json json =
        nlohmann::json::parse(exported(StatisticsPanel::File::Json, QStringLiteral("r.json")).toStdString());
    EXPECT_EQ(json["runs"].size(), 3u);
    EXPECT_EQ(json["runs"][2]["frames"][2]["missed_pixels"], 12);
}

/// The character data of an XML document; fails the test if it is not well-formed.
QString textOf(const QByteArray& xml) {
    QXmlStreamReader reader(xml);
    QString text;
    while (!reader.atEnd())
        if (reader.readNext() == QXmlStreamReader::Characters) text += reader.text().toString() + QLatin1Char(' ');
    EXPECT_FALSE(reader.hasError()) << reader.errorString().toStdString();
    return text;
}

TEST_F(Panel, plotsAreVectorsWithTextAsText) {
    showResult();
    struct Expected {
        StatisticsPanel::Tab tab;
        QString text;
    };
    for (const Expected& expected : {Expected{StatisticsPanel::Times, QStringLiteral("frustum box=length")},
                                     Expected{StatisticsPanel::Poses, QStringLiteral("missed")},
                                     Expected{StatisticsPanel::Path, QStringLiteral("Missed pixels")},
                                     Expected{StatisticsPanel::Pareto, QStringLiteral("0 (< 3/4)")},
                                     Expected{StatisticsPanel::Sphere, QStringLiteral("90°")}}) {
        SCOPED_TRACE(int(expected.tab));
        panel.showTab(expected.tab);
        const QByteArray svg = exported(StatisticsPanel::File::Svg, QStringLiteral("p.svg"));
        EXPECT_TRUE(svg.contains("<text"));
        EXPECT_FALSE(svg.contains("<image")) << "a picture of the plot, not the plot";
        EXPECT_TRUE(textOf(svg).contains(expected.text)) << textOf(svg).toStdString();
        const QByteArray pdf = exported(StatisticsPanel::File::Pdf, QStringLiteral("p.pdf"));
        EXPECT_TRUE(pdf.startsWith("%PDF-"));
        EXPECT_TRUE(pdf.contains("/FontFile2") || pdf.contains("/FontFile3")) << "no embedded font";
        EXPECT_FALSE(pdf.contains("/Subtype /Image"));
    }
}

TEST_F(Panel, reportNeedsNoOtherFileAndEscapesEverything) {
    std::vector<Instance> instances = result.request.scene->instances();
    const auto named = std::make_shared<Scene>("<script>alert('&')</script>", result.request.scene->meshes(), instances);
    result.request.scene = named;
    panel.setScene(named, {"it's a field.obj", {}});
    showResult();
    const QByteArray html = exported(StatisticsPanel::File::Html, QStringLiteral("r.html"));
    EXPECT_TRUE(html.startsWith("<!DOCTYPE html>"));
    EXPECT_FALSE(html.contains("<script>"));
    EXPECT_TRUE(html.contains("&lt;script&gt;"));
    EXPECT_TRUE(html.contains("&lt;renderer &amp; co&gt;"));
    EXPECT_FALSE(html.contains("<?xml"));
    EXPECT_FALSE(html.contains("src=")) << "another file";
    EXPECT_EQ(html.count("<svg"), 3 + 2 * 3);
    EXPECT_TRUE(html.contains("cullbench measure"));
    EXPECT_TRUE(html.contains("it'\\''s a field.obj")) << "quoted for a shell";
    EXPECT_TRUE(html.contains("-s all,backface,frustum:box=length "));
    EXPECT_TRUE(html.contains("--repeat 3"));
    EXPECT_TRUE(html.contains(named->sha256().c_str()));
}

TEST_F(Panel, reportsHaveAConclusionAndThePictureOfTheScene) {
    QImage picture(40, 30, QImage::Format_RGB32);
    picture.fill(Qt::red);
    panel.setScenePicture([picture] { return picture; });
    showResult();
    const QString html = QString::fromUtf8(exported(StatisticsPanel::File::Html, QStringLiteral("r.html")));
    EXPECT_EQ(html.count(QStringLiteral("<img ")), 1);
    EXPECT_EQ(html.count(QStringLiteral("src=\"data:image/png;base64,")), 1) << "within the page";
    const QStringList sentences = conclusionsOf(result);
    ASSERT_FALSE(sentences.isEmpty());
    for (const QString& sentence : sentences) EXPECT_TRUE(html.contains(sentence.toHtmlEscaped())) << sentence.toStdString();
    EXPECT_LT(html.indexOf(sentences.front().toHtmlEscaped()), html.indexOf(QStringLiteral("SHA-256"))) << "first of all";
    const QByteArray pdf = exported(StatisticsPanel::File::Report, QStringLiteral("r.pdf"));
    EXPECT_TRUE(pdf.startsWith("%PDF-"));
    EXPECT_GE(pdf.count("/Subtype /Image"), 2) << "the scene and the plots";
    EXPECT_TRUE(pdf.contains("/FontFile2") || pdf.contains("/FontFile3"));
}

RunFigures run(const char* label, double speed, double scatter, std::optional<double> ppm,
               Promise promise = Promise::Conservative) {
    RunFigures figures;
    figures.label = QLatin1String(label);
    figures.promise = promise;
    figures.speedup = {speed, {speed - scatter, speed + scatter}, true};
    figures.missedPpm = ppm;
    figures.poses = {{.pose = 3, .missedPixels = 1}, {.pose = 7, .missedPixels = 5}};
    return figures;
}

TEST(Conclusion, namesTheFastestWithoutAndWithLossesAndBrokenPromises) {
    using ::testing::HasSubstr;
    const auto said = [](const std::vector<RunFigures>& runs) {
        return conclusionsOf(runs).join(QLatin1Char('\n')).toStdString();
    };
    const RunFigures slow = run("slow", 1.2, 0.1, 0.0), fast = run("fast", 1.5, 0.1, 0.0);
    const RunFigures lossy = run("lossy", 3.0, 0.1, 250.0, Promise::Approximate);
    EXPECT_THAT(said({slow, fast, lossy}), HasSubstr("Fastest without a lost pixel: fast, ×1.50 (95 %: 1.40 to 1.60)"));
    EXPECT_THAT(said({slow, fast, lossy}), HasSubstr("Faster, with losses: lossy, ×3.00"));
    EXPECT_THAT(said({slow, fast, lossy}), HasSubstr("250 of a million pixels, most of them at pose 7"));
    // An interval that holds 1 is no gain.
    EXPECT_THAT(said({run("unsure", 1.05, 0.1, 0.0)}), HasSubstr("No strategy that loses no pixel is surely faster"));
    // Slower than what loses nothing: not worth its losses.
    EXPECT_THAT(said({fast, run("lossy", 1.3, 0.1, 9.0, Promise::Approximate)}), ::testing::Not(HasSubstr("with losses")));
    EXPECT_THAT(said({fast, run("liar", 1.3, 0.1, 9.0)}), HasSubstr("liar promises to lose nothing and lost 9.0 of a million"));
    EXPECT_THAT(said({run("unseen", 1.3, 0.1, std::nullopt)}), HasSubstr("Losses were not measured"));
    RunFigures baseline = run("all", 1.0, 0.0, 0.0);
    baseline.baseline = true;
    EXPECT_THAT(said({baseline}), HasSubstr("Only baselines were measured"));
}

TEST_F(Panel, experimentsStandBesideEachOtherInTheHistory) {
    showResult();
    const QAbstractItemModelTester tester(&panel.history(), QAbstractItemModelTester::FailureReportingMode::Fatal);
    EXPECT_EQ(panel.history().columnCount(), 0);
    const std::vector<ResultRow> rows = resultRows(result);
    std::vector<ResultRow> later(rows.begin(), rows.end() - 1);
    const QDateTime now = QDateTime::currentDateTime();
    panel.setHistory({{QStringLiteral("old"), StatisticsPanel::pathAndSize(result.request), now.addSecs(-60), rows},
                      {QStringLiteral("new"), StatisticsPanel::pathAndSize(result.request), now, later}});
    const HistoryModel& history = panel.history();
    ASSERT_EQ(history.columnCount(), 2);
    ASSERT_EQ(history.rowCount(), int(rows.size()));
    EXPECT_TRUE(history.headerData(0, Qt::Horizontal, Qt::DisplayRole).toString().startsWith(QStringLiteral("new, ")));
    for (int row = 0; row < history.rowCount(); ++row) {
        const QString name = history.headerData(row, Qt::Vertical, Qt::DisplayRole).toString();
        const auto measured = std::ranges::find(rows, name, &ResultRow::name);
        ASSERT_NE(measured, rows.end()) << name.toStdString();
        const QString cell = history.index(row, 1).data().toString();
        EXPECT_TRUE(cell.startsWith(QStringLiteral("×") + QLocale().toString(measured->speedup->ratio, 'f', 2)))
            << cell.toStdString();
        const bool again = std::ranges::find(later, name, &ResultRow::name) != later.end();
        EXPECT_EQ(history.index(row, 0).data().toString() == QStringLiteral("–"), !again);
    }
    panel.showTab(StatisticsPanel::History);
}

TEST_F(Panel, plotsOfPosesNameTheirStrategy) {
    showResult();
    const QString html = QString::fromUtf8(exported(StatisticsPanel::File::Html, QStringLiteral("r.html")));
    for (const char* plot : {"Time and loss by pose", "Loss by direction of view"})
        for (const char* strategy : {"all", "backface", "frustum box=length"}) {
            const QString title = QStringLiteral("%1 · %2").arg(QLatin1String(plot), QLatin1String(strategy));
            EXPECT_EQ(html.count(QStringLiteral("<h2>%1</h2>").arg(title)), 1) << title.toStdString();
            // The title occurs in the picture as well as in the heading.
            EXPECT_EQ(html.count(QStringLiteral(">%1</text>").arg(title)), 1) << title.toStdString();
        }
    for (const auto& [tab, title] : {std::pair(StatisticsPanel::Poses, "Time and loss by pose · frustum box=length"),
                                     {StatisticsPanel::Sphere, "Loss by direction of view · frustum box=length"}}) {
        panel.showTab(tab);
        const QString svg = textOf(exported(StatisticsPanel::File::Svg, QStringLiteral("p.svg")));
        EXPECT_EQ(svg.count(QString::fromUtf8(title)), 2) << svg.toStdString();
    }
}

TEST_F(Panel, paretoPointsHaveTheirNamesBesideThem) {
    showResult();
    panel.showTab(StatisticsPanel::Pareto);
    const QString svg = textOf(exported(StatisticsPanel::File::Svg, QStringLiteral("p.svg")));
    const QStringList words = svg.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    // One label in the legend and one at the point.
    EXPECT_EQ(words.count(QStringLiteral("all")), 2) << svg.toStdString();
    EXPECT_EQ(words.count(QStringLiteral("frustum")), 2) << svg.toStdString();
}

TEST_F(Panel, placeThatCannotBeWrittenIsOneSentence) {
    showResult();
    panel.showTab(StatisticsPanel::Times);
    for (const StatisticsPanel::File file :
         {StatisticsPanel::File::Csv, StatisticsPanel::File::Json, StatisticsPanel::File::Svg, StatisticsPanel::File::Pdf,
          StatisticsPanel::File::Html, StatisticsPanel::File::Report}) {
        for (const std::string& place : {std::string("/dev/full"), folder.filePath(QStringLiteral("no/folder")).toStdString()}) {
            SCOPED_TRACE(place);
            failures.clear();
            panel.exportTo(file, place);
            ASSERT_TRUE(QTest::qWaitFor([this] { return !failures.empty(); }, kPatience));
            EXPECT_THAT(failures.front(), ::testing::HasSubstr("cannot be written"));
        }
    }
    EXPECT_TRUE(files.isEmpty());
}

TEST_F(Panel, chosenPoseIsPassedOn) {
    showResult();
    panel.showTab(StatisticsPanel::Poses);
    QSignalSpy chosen(&panel, &StatisticsPanel::poseChosen);
    auto* strip = panel.findChild<PoseStrip*>();
    ASSERT_NE(strip, nullptr);
    QTest::keyClick(strip, Qt::Key_End);
    QTest::keyClick(strip, Qt::Key_Return);
    ASSERT_EQ(chosen.size(), 1);
    EXPECT_EQ(chosen[0][0].toInt(), 3);
}

}  // namespace
}  // namespace cullscope::ui::statistics_panel_test
