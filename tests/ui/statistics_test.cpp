#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "tests/core/measure/small_experiment.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/sphere_map.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/statistics/time_bar.h"

namespace cullscope::ui {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;
constexpr int kPatience = 60'000;  // ms

/// One frame of made-up figures.
FrameMeasurement frame(size_t pose, double milliseconds, uint64_t missed) {
    FrameMeasurement measured;
    measured.pose = pose;
    measured.frameMilliseconds = milliseconds;
    measured.cullMilliseconds = milliseconds / 4;
    measured.repetitions = 3;
    measured.consideredTriangles = 100;
    measured.accuracy = Accuracy{};
    measured.accuracy->coveredPixels = 1'000'000;
    measured.accuracy->missedPixels = missed;
    return measured;
}

RunMeasurement run(const std::string& id, double milliseconds, const std::vector<uint64_t>& missed) {
    RunMeasurement made;
    made.strategy = test::request(id);
    made.promise = Promise::Conservative;
    uint64_t all = 0;
    for (size_t pose = 0; pose < missed.size(); ++pose) {
        made.frames.push_back(frame(pose, milliseconds, missed[pose]));
        all += missed[pose];
    }
    made.summary.fpsOverall = made.summary.fpsMin = made.summary.fpsMax = 1000.0 / milliseconds;
    made.summary.cullShare = 0.25;
    made.summary.culledFraction = 0.6;
    made.summary.missedPixelRate = double(all) / 1e6 / double(missed.size());
    made.summary.speedupVsBackface = 8.0 / milliseconds;
    made.summary.speedupVsBackfaceCi95 = {7.0 / milliseconds, 9.0 / milliseconds};
    made.summary.speedupVsAll = 10.0 / milliseconds;
    made.summary.speedupVsAllCi95 = {9.0 / milliseconds, 11.0 / milliseconds};
    return made;
}

/// Three strategies over four poses; `frustum` loses pixels at two of them.
MeasureResult madeUpResult() {
    MeasureResult result;
    result.request = test::smallExperiment({"all", "backface", "frustum"});
    result.request.path = cameraPath("fibonacci:4", *result.request.scene);
    result.gl.renderer = "<renderer & co>";
    result.runs = {run("all", 10.0, {0, 0, 0, 0}), run("backface", 8.0, {0, 0, 0, 0}), run("frustum", 4.0, {0, 5, 12, 0})};
    result.request.strategies[2].parameters.setFromText("box", "length");
    result.runs[2].strategy = result.request.strategies[2];
    return result;
}

QString cell(const ResultTableModel& model, int row, int column) { return model.index(row, column).data().toString(); }

TEST(ResultTable, rowsSayWhatWasMeasured) {
    ResultTableModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    EXPECT_EQ(model.rowCount(), 0);
    model.setRows(resultRows(madeUpResult()));
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_TRUE(cell(model, 2, ResultTableModel::Name).endsWith(QStringLiteral("box=length")));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Speedup), QStringLiteral("×2.00 [1.75, 2.25]"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::SpeedupAll), QStringLiteral("×2.50 [2.25, 2.75]"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Fps), QStringLiteral("250"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::CullShare), QStringLiteral("25 %"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Submitted), QStringLiteral("40 %"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Missed), QStringLiteral("17"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::MissedPpm), QStringLiteral("4.3"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Worst), QStringLiteral("2"));
    EXPECT_EQ(model.index(2, 0).data(ResultTableModel::kPoseRole).toInt(), 2);
    EXPECT_TRUE(model.rows()[2].promiseBroken);
    EXPECT_EQ(cell(model, 0, ResultTableModel::Worst), QStringLiteral("–")) << "nothing is missed anywhere";
    EXPECT_FALSE(model.index(0, 0).data(ResultTableModel::kPoseRole).isValid());
    model.setRows(resultRows(madeUpResult()));
    model.retranslate();
    model.setRows({});
    EXPECT_EQ(model.rowCount(), 0);
}

TEST(ResultTable, whatIsNotMeasuredIsNoZero) {
    MeasureResult result = madeUpResult();
    for (RunMeasurement& measured : result.runs) {
        measured.summary.missedPixelRate.reset();
        for (FrameMeasurement& one : measured.frames) one.accuracy.reset();
    }
    ResultTableModel model;
    model.setRows(resultRows(result));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Missed), QStringLiteral("–"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::MissedPpm), QStringLiteral("–"));
    LiveFigures stale;
    stale.strategy = test::request("frustum");
    stale.figures.state = Figures::State::Stale;
    model.setRows(liveRows({stale}));
    for (int column = 1; column < ResultTableModel::ColumnCount; ++column)
        EXPECT_EQ(cell(model, 0, column), QStringLiteral("–")) << column;
}

TEST(RunFigures, directionsAreSeenFromTheScenesCentre) {
    MeasureResult result = madeUpResult();
    const Vec3 centre = result.request.scene->boundingSphere().centre;
    result.request.path.poses[0].eye = centre + Vec3(0, 0, 5);
    result.request.path.poses[1].eye = centre + Vec3(5, 0, 0);
    result.request.path.poses[2].eye = centre + Vec3(0, 5, 0);
    result.request.path.poses[3].eye = centre + Vec3(-5, -5, 0);
    const std::vector<PoseFigures> poses = runFigures(result).front().poses;
    EXPECT_NEAR(poses[0].azimuth, 0.0, 1e-9);
    EXPECT_NEAR(poses[1].azimuth, 90.0, 1e-9);
    EXPECT_NEAR(poses[2].elevation, 90.0, 1e-9);
    EXPECT_NEAR(poses[3].azimuth, -90.0, 1e-9);
    EXPECT_NEAR(poses[3].elevation, -45.0, 1e-9);
}

TEST(RunFigures, leastLossIsClearlyApartFromNone) {
    EXPECT_EQ(lossShare(0.0), 0.0);
    EXPECT_GE(lossShare(1e-6), 0.2);
    EXPECT_LT(lossShare(100.0), lossShare(10'000.0));
    EXPECT_EQ(lossShare(1e6), 1.0);
    EXPECT_EQ(ppmText(0.0), QStringLiteral("0"));
    EXPECT_EQ(ppmText(0.043), QStringLiteral("0.043"));
    EXPECT_EQ(ppmText(4.25), QStringLiteral("4.3"));
    EXPECT_EQ(ppmText(1234.5), QStringLiteral("1,235"));
}

TEST(ParetoPlot, nothingMissedHasABandOfItsOwnBelowEveryLoss) {
    ParetoPlot plot;
    EXPECT_TRUE(plot.empty());
    plot.setRuns(runFigures(madeUpResult()));
    EXPECT_FALSE(plot.empty());
    EXPECT_EQ(plot.zeroLabel(), QStringLiteral("0 (< 3/4)"));
    EXPECT_LE(plot.height(0.0), plot.lowestDecade() - 1.0);
    EXPECT_GE(plot.height(1.0), plot.lowestDecade());
    EXPECT_DOUBLE_EQ(plot.height(1000.0) - plot.height(10.0), 2.0);
}

TEST(ParetoPlot, lossThatWasNotMeasuredIsLeftOut) {
    std::vector<RunFigures> runs = runFigures(madeUpResult());
    for (RunFigures& one : runs) one.missedPpm.reset();
    ParetoPlot plot;
    plot.setRuns(runs);
    EXPECT_TRUE(plot.empty());
    EXPECT_TRUE(plot.accessibleDescription().contains(QStringLiteral("not measured")));
}

/// The middle of the pose's column.
QPoint columnOf(const QWidget& strip, size_t pose, size_t poses) {
    // Found by asking the strip itself would prove nothing: the column's colour is looked for in its picture.
    const QImage picture = const_cast<QWidget&>(strip).grab().toImage();
    const int y = picture.height() / 2 - 10;
    const QRgb colour = PlotColours(strip.palette()).draw.rgb();
    std::vector<int> starts;
    for (int x = 1; x < picture.width(); ++x)
        if (picture.pixel(x, y) == colour && picture.pixel(x - 1, y) != colour) starts.push_back(x);
    EXPECT_EQ(starts.size(), poses);
    return pose < starts.size() ? QPoint(starts[pose] + 8, y) : QPoint();
}

TEST(PoseStrip, clickAndKeysChooseThePose) {
    PoseStrip strip;
    strip.resize(600, 160);
    strip.setRun(runFigures(madeUpResult())[2], 4);
    QSignalSpy chosen(&strip, &PoseStrip::poseChosen);
    QTest::mouseClick(&strip, Qt::LeftButton, {}, columnOf(strip, 2, 4));
    ASSERT_EQ(chosen.size(), 1);
    EXPECT_EQ(chosen[0][0].toInt(), 2);
    QTest::keyClick(&strip, Qt::Key_Right);
    QTest::keyClick(&strip, Qt::Key_Right);
    EXPECT_EQ(strip.current(), 3) << "past the last";
    QTest::keyClick(&strip, Qt::Key_Return);
    QTest::keyClick(&strip, Qt::Key_Home);
    QTest::keyClick(&strip, Qt::Key_Left);
    QTest::keyClick(&strip, Qt::Key_Return);
    ASSERT_EQ(chosen.size(), 3);
    EXPECT_EQ(chosen[1][0].toInt(), 3);
    EXPECT_EQ(chosen[2][0].toInt(), 0);
    EXPECT_TRUE(strip.accessibleDescription().contains(QStringLiteral("Pose 0")));
    QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(598, 20));
    EXPECT_EQ(chosen.size(), 3) << "beside the columns";
}

TEST(PoseStrip, partOfAPathLeavesPlaceForTheRest) {
    RunFigures half = runFigures(madeUpResult())[2];
    half.poses.resize(2);
    PoseStrip strip;
    strip.resize(600, 160);
    strip.setRun(half, 4);
    const QPoint second = columnOf(strip, 1, 2);
    strip.setRun(runFigures(madeUpResult())[2], 4);
    EXPECT_EQ(columnOf(strip, 1, 4), second) << "the columns moved when more poses came in";
}

TEST(SphereMap, clickOnADotChoosesItsPose) {
    MeasureResult result = madeUpResult();
    const Vec3 centre = result.request.scene->boundingSphere().centre;
    // In a row over the map's middle.
    result.request.path.poses[0].eye = centre + Vec3(0, 0, 5);
    result.request.path.poses[1].eye = centre + Vec3(5, 0, 0);
    result.request.path.poses[2].eye = centre + Vec3(-5, 0, 0);
    result.request.path.poses[3].eye = centre + Vec3(0, 5, 0.01);
    SphereMap map;
    map.resize(400, 200);
    map.setRun(runFigures(result)[2], 4);
    QSignalSpy chosen(&map, &SphereMap::poseChosen);
    for (int y = 20; y < 160; y += 6)
        for (int x = 0; x < 400; x += 6) QTest::mouseClick(&map, Qt::LeftButton, {}, QPoint(x, y));
    std::vector<int> order;
    for (const QList<QVariant>& one : chosen)
        if (order.empty() || order.back() != one[0].toInt()) order.push_back(one[0].toInt());
    EXPECT_THAT(order, ::testing::IsSupersetOf({0, 1, 2, 3}));
    const auto at = [&](int pose) { return std::find(order.begin(), order.end(), pose) - order.begin(); };
    EXPECT_LT(at(3), at(2)) << "the pole lies above";
    EXPECT_LT(at(2), at(0)) << "azimuth −90° lies to the left";
    EXPECT_LT(at(0), at(1));
}

TEST(TimeBar, rowsFitTheWidth) {
    TimeBar bar;
    EXPECT_TRUE(bar.empty());
    bar.setEntries(
        {{QStringLiteral("frustum box=length facing=two-sided"), 1.0, 2.0, false}, {QStringLiteral("all"), 0.0, 9.0, true}});
    EXPECT_LT(bar.neededHeight(926), bar.neededHeight(300)) << "a narrow bar puts its labels above";
    EXPECT_TRUE(bar.accessibleDescription().contains(QStringLiteral("cull")));
}

/// A panel with a result of its scene, and what it says.
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
        panel.setResult(result);
        panel.setRunning(false);
        ASSERT_TRUE(QTest::qWaitFor([this] { return panel.model().rowCount() == 3; }, kPatience));
    }
    /// Exports to a file of the folder, gives its contents.
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

TEST_F(Panel, startAsksForTheChosenExperiment) {
    std::vector<ExperimentSettings> asked;
    QObject::connect(&panel, &StatisticsPanel::startRequested,
                     [&](const ExperimentSettings& settings) { asked.push_back(settings); });
    panel.bar().start();
    ASSERT_EQ(asked.size(), 1u);
    EXPECT_EQ(asked[0].path.name, "walk:16") << "the default of a scene of many objects";
    EXPECT_EQ(asked[0].path.poses.size(), 16u);
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
    EXPECT_EQ(asked[0].path.poses.size(), 5u);
    EXPECT_EQ(asked[0].path.name, good);
    CameraPath recorded = cameraPath("orbit:2", *result.request.scene);
    recorded.name = "mine.json";
    panel.setRecordedPath(recorded);
    panel.bar().start();
    EXPECT_EQ(asked.back().path.name, good) << "what was chosen stays chosen";
}

TEST_F(Panel, resultOfAnotherSceneIsDropped) {
    MeasureResult other = madeUpResult();
    panel.setRunning(true);
    panel.setResult(other);
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
    for (int i = 0; i < 50; ++i) panel.setResult(result);
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

/// Whether text is XML, and all of its character data.
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
    EXPECT_EQ(html.count("<svg"), 5);
    EXPECT_TRUE(html.contains("cullbench measure"));
    EXPECT_TRUE(html.contains("it'\\''s a field.obj")) << "quoted for a shell";
    EXPECT_TRUE(html.contains("-s all,backface,frustum:box=length "));
    EXPECT_TRUE(html.contains("--repeat 3"));
    EXPECT_TRUE(html.contains(named->sha256().c_str()));
}

TEST_F(Panel, placeThatCannotBeWrittenIsOneSentence) {
    showResult();
    panel.showTab(StatisticsPanel::Times);
    for (const StatisticsPanel::File file : {StatisticsPanel::File::Csv, StatisticsPanel::File::Json, StatisticsPanel::File::Svg,
                                             StatisticsPanel::File::Pdf, StatisticsPanel::File::Html}) {
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
}  // namespace cullscope::ui
