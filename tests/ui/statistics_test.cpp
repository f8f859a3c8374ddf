#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QTest>

#include "core/image/plot_labels.h"
#include "core/measure/summary.h"
#include "tests/ui/made_up_result.h"
#include "ui/models/metrics_words.h"
#include "ui/plots/plot_file.h"
#include "ui/plots/plot_painter.h"
#include "ui/statistics/pareto_plot.h"
#include "ui/statistics/pose_strip.h"
#include "ui/statistics/result_table_model.h"
#include "ui/statistics/sphere_map.h"
#include "ui/statistics/time_bar.h"
#include "ui/text/wording.h"

namespace cullscope::ui::statistics_test {
namespace {

constexpr auto kFatal = QAbstractItemModelTester::FailureReportingMode::Fatal;

QString cell(const ResultTableModel& model, int row, int column) { return model.index(row, column).data().toString(); }

/// The times of one view, as a header and as an experiment of one pose have them.
TEST(ResultTable, timesOfAViewAreTheSameFactorInHeaderTooltipAndTable) {
    const ViewTimes times{{21.0, 22.0, 20.5, 29.0, 21.5}, {7.0, 7.2, 6.9, 7.1, 9.0}};
    LiveFigures live{QStringLiteral("A"), test::request("frustum"), Promise::Conservative, {}};
    live.figures.state = ViewMetrics::State::Ready;
    live.figures.frameMilliseconds = 7.1;
    live.figures.speedup = ratioOfTotals({&times, 1});

    MeasureResult result = madeUpResult();
    result.runs = {run("backface", 21.5, {0}), run("frustum", 7.1, {0})};
    result.runs[0].frames[0].frameTimes = times.baseline;
    result.runs[1].frames[0].frameTimes = times.subject;
    for (RunMeasurement& measured : result.runs) {
        measured.ownRule = baselineUnder(Facing::Front);
        measured.summary = summaryOf(measured, result.runs, *result.request.scene);
    }

    const ResultRow ofExperiment = resultRows(result)[1], ofView = liveRows({live})[0];
    EXPECT_EQ(ofExperiment.speedup, ofView.speedup);
    EXPECT_EQ(ResultTableModel::value(ofExperiment, ResultTableModel::Speedup),
              ResultTableModel::value(ofView, ResultTableModel::Speedup));
    EXPECT_EQ(runFigures(result)[1].speedup, *ofView.speedup) << "the plots";
    EXPECT_TRUE(metricsLine(live.figures).startsWith(QStringLiteral("×3.0 ·"))) << metricsLine(live.figures).toStdString();
    EXPECT_TRUE(metricsDetails(live.figures, {}).contains(speedWithInterval(*ofView.speedup)));
    EXPECT_EQ(speedWithInterval({3.14, {2.9, 3.3}}), QStringLiteral("×3.1 (2.90 – 3.30)"));
}

TEST(ResultTable, viewsHaveTheirShareOfTheHeadroomWhereCullingCanGainAnything) {
    LiveFigures view{QStringLiteral("A"), test::request("frustum"), Promise::Conservative, {}};
    view.figures.state = ViewMetrics::State::Ready;
    view.figures.timed = true;
    view.figures.frameMilliseconds = 15.0;
    view.figures.headroom = ViewHeadroom{{2.0, {1.9, 2.1}}, "all", RatioEstimate{0.5, {}, false}};
    EXPECT_EQ(ResultTableModel::value(liveRows({view})[0], ResultTableModel::Headroom), QStringLiteral("50 %"));
    EXPECT_TRUE(metricsDetails(view.figures, {}).contains(QStringLiteral("at most ×2.0 (1.90 – 2.10) against all")));
    EXPECT_TRUE(metricsDetails(view.figures, {}).contains(QStringLiteral("Of this headroom: 50 %")));
    view.figures.headroom->share->ratio = -0.002;
    EXPECT_TRUE(metricsDetails(view.figures, {}).contains(QStringLiteral("Of this headroom: 0 %"))) << "and no -0 %";
    view.figures.headroom->share.reset();
    EXPECT_FALSE(liveRows({view})[0].headroomShare);
    EXPECT_FALSE(metricsDetails(view.figures, {}).contains(QStringLiteral("Of this headroom")));
    // Drawing everything is ×1, so that no less is the most that can be gained.
    view.figures.headroom->most = {0.92, {0.81, 1.02}};
    EXPECT_TRUE(metricsDetails(view.figures, {}).contains(QStringLiteral("Nothing could be gained here")));
    EXPECT_FALSE(metricsDetails(view.figures, {}).contains(QStringLiteral("at most")));
}

TEST(ResultTable, limitStandsInTableAndPlotsBesideTheStrategies) {
    MeasureResult result = madeUpResult();
    result.limit = run("oracle", 1.0, {0, 0});
    for (FrameMeasurement& frame : result.limit->frames) frame.accuracy.reset();
    const size_t strategies = madeUpResult().runs.size();
    ASSERT_EQ(resultRows(result).size(), strategies + 1);
    EXPECT_EQ(resultRows(result).back().id, QStringLiteral("oracle"));
    const std::vector<RunFigures> figures = runFigures(result);
    ASSERT_EQ(figures.size(), strategies + 1);
    EXPECT_TRUE(figures.back().limit);
    EXPECT_EQ(figures.back().missedPpm, 0.0) << "it draws what is visible";
}

TEST(ResultTable, rateOfNothingLostSaysInHowManyViews) {
    ResultRow row;
    row.missedPpm = 0.0;
    EXPECT_EQ(ResultTableModel::value(row, ResultTableModel::MissedPpm), QStringLiteral("0")) << "at the present camera";
    row.views = 16;
    EXPECT_EQ(ResultTableModel::value(row, ResultTableModel::MissedPpm), QStringLiteral("0 (< 3/16)"));
    row.missedPpm = 4.3;
    EXPECT_EQ(ResultTableModel::value(row, ResultTableModel::MissedPpm), QStringLiteral("4.3"));
}

TEST(ResultTable, rowsSayWhatWasMeasured) {
    ResultTableModel model;
    const QAbstractItemModelTester tester(&model, kFatal);
    EXPECT_EQ(model.rowCount(), 0);
    model.setRows(resultRows(madeUpResult()));
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_TRUE(cell(model, 2, ResultTableModel::Name).endsWith(QStringLiteral("box=length")));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Speedup), QStringLiteral("×2.00 [1.75, 2.25]"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::SpeedupOverTriangles), QStringLiteral("×2.50 [2.25, 2.75]"));
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
    stale.figures.state = ViewMetrics::State::Stale;
    model.setRows(liveRows({stale}));
    for (int column = 1; column < ResultTableModel::columns(); ++column)
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
    EXPECT_EQ(significantText(0.0), QStringLiteral("0"));
    EXPECT_EQ(significantText(0.043), QStringLiteral("0.043"));
    EXPECT_EQ(significantText(4.25), QStringLiteral("4.3"));
    EXPECT_EQ(significantText(1234.5), QStringLiteral("1,235"));
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

/// The number of pixels that are the top left corner of a square of one colour; no line of a plot is as wide as such a square.
int squaresOf(const QImage& picture, const QColor& colour) {
    constexpr int kSide = 5;
    const auto filled = [&](int left, int top) {
        for (int y = top; y < top + kSide; ++y)
            for (int x = left; x < left + kSide; ++x)
                if (picture.pixel(x, y) != colour.rgb()) return false;
        return true;
    };
    int count = 0;
    for (int y = 0; y + kSide <= picture.height(); ++y)
        for (int x = 0; x + kSide <= picture.width(); ++x) count += filled(x, y) ? 1 : 0;
    return count;
}

TEST(ParetoPlot, baselinesAndKeysOfShapesAreToldApart) {
    const auto plotOf = [](const std::string& id) {
        std::vector<RunFigures> runs = runFigures(madeUpResult());
        std::erase_if(runs, [&](const RunFigures& one) { return one.id.toStdString() != id; });
        ParetoPlot plot;
        plot.resize(500, 260);
        plot.setRuns(runs);
        return std::pair(plot.grab().toImage(), PlotColours(plot.palette()));
    };
    const auto [all, colours] = plotOf("all");
    const QImage backface = plotOf("backface").first;
    EXPECT_GT(squaresOf(all, colours.baselineCull), 0);
    EXPECT_EQ(squaresOf(backface, colours.baselineCull), 0);
    EXPECT_GT(squaresOf(plotOf("frustum").first, colours.series(0)), 0);
    EXPECT_EQ(squaresOf(all, colours.faintText), 0) << "a filled key of a shape";
    EXPECT_EQ(squaresOf(backface, colours.faintText), 0);
}

TEST(PointLabels, crowdedLabelsLieApartAndInside) {
    const PlotStyle style = plotStyle(QFont(), PlotColours(QPalette()));
    const QRectF bounds(0, 0, 300, 300);
    std::vector<PointLabel> labels;
    for (int i = 0; i < 6; ++i) labels.push_back({{40.0 + 3.0 * i, 150.0}, "strategy" + std::to_string(i)});
    labels.push_back({{298.0, 2.0}, "corner"});
    std::vector<QRectF> places;
    for (const PlotBox& box : placeLabels(labels, style, {0, 0, 300, 300}, 11.0))
        places.emplace_back(QPointF(box.left, box.top), QPointF(box.right, box.bottom));
    ASSERT_EQ(places.size(), labels.size());
    for (size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(bounds.contains(places[i])) << i;
        for (size_t j = 0; j < i; ++j) EXPECT_FALSE(places[i].intersects(places[j])) << i << " over " << j;
        for (const PointLabel& label : labels) EXPECT_FALSE(places[i].contains({label.point.x, label.point.y})) << i;
    }
}

TEST(ResultTable, pixelsWithinSnappingAreNotMissedAndStandApart) {
    MeasureResult result = madeUpResult();
    RunMeasurement& backface = result.runs[1];
    backface.facing = Facing::Front;
    backface.referenceFacing = Facing::TwoSided;
    backface.frames[1].accuracy->missedPixels = 9;
    backface.frames[1].missedBeyondSnapping = 3;
    ResultTableModel model;
    model.setRows(resultRows(result));
    EXPECT_EQ(cell(model, 1, ResultTableModel::Missed), QStringLiteral("3"));
    EXPECT_NE(cell(model, 1, ResultTableModel::Snapped), QStringLiteral("–"));
    EXPECT_EQ(cell(model, 2, ResultTableModel::Snapped), QStringLiteral("–"))
        << "all of its loss is its own: nothing to tell apart";
}

/// The centre of the column of a pose.
QPoint columnOf(const QWidget& strip, size_t pose, size_t poses) {
    // The test finds the column by its colour in a picture: a position computed by the strip itself would prove nothing.
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

TEST(PoseStrip, theScaleOfLossesIsLabelled) {
    PoseStrip strip;
    RunFigures run;
    run.poses = {{.pose = 0, .frameMilliseconds = 2.0, .missedPixels = 10, .missedPpm = 1000.0}};
    strip.setRun(run, 1);
    const QString svg = QString::fromUtf8(plotSvg(strip, {600, 300}));
    for (const char* tick : {"0.001 %", "0.1 %", "10 %"})
        EXPECT_EQ(svg.count(QStringLiteral("missed ") + QLatin1String(tick) + QLatin1Char('<')), 1) << tick;
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
    // Eyes in a horizontal row across the middle of the map.
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

}  // namespace
}  // namespace cullscope::ui::statistics_test
