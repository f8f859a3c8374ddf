// The plot of any two figures: places, bands of zero, fronts, points of a sweep's table.
#include "core/experiments/trade_plot.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/experiments/sweeps.h"
#include "core/measure/field_figures.h"

namespace cullscope::test::trade_plot_test {
namespace {

using testing::ElementsAre;

RatioEstimate plain(double value) { return {value, {value, value}, false}; }

TradePoint pointOf(const std::string& name, double speed, double lost, const std::string& sweep = "") {
    TradePoint point;
    point.name = point.label = name;
    point.sweep = sweep;
    point.views = 16;
    point.values = {{kUsualAcross, plain(speed)}, {kUsualUp, plain(lost)}};
    return point;
}

const TradeFigure& speed() { return tradeFigure(kUsualAcross); }
const TradeFigure& loss() { return tradeFigure(kUsualUp); }

TEST(TradePlot, zeroStandsOnABandOfItsOwnBelowTheLeastLoss) {
    const TradePlot plot({pointOf("none", 1.0, 0.0), pointOf("some", 2.0, 3e-8), pointOf("much", 3.0, 0.02)}, speed(), loss());
    EXPECT_EQ(plot.lowestDecade(loss()), -2) << "0.03 of a million";
    EXPECT_DOUBLE_EQ(plot.place(plot.points()[0]).y, -3.0);
    EXPECT_DOUBLE_EQ(plot.place(plot.points()[2]).y, std::log10(2e4));
    EXPECT_EQ(plot.zeroLabel(loss()), "0 (< 3/16)");
    const LinePlot drawn = plot.plot({});
    ASSERT_FALSE(drawn.y.ticks.empty());
    EXPECT_EQ(drawn.y.ticks.front().label, "0 (< 3/16)");
    ASSERT_EQ(drawn.bars.size(), 1u) << "the band across the whole plot";
    EXPECT_LT(drawn.bars.front().boxes.front().bottom, -3.0);
    EXPECT_GT(drawn.bars.front().boxes.front().top, -3.0);
    EXPECT_LT(drawn.bars.front().boxes.front().top, std::log10(0.03));
}

TEST(TradePlot, pointsOfZeroSayHowManyViewsItHoldsOfWhereTheseDiffer) {
    std::vector<TradePoint> points{pointOf("long", 1.0, 0.0), pointOf("short", 2.0, 0.0), pointOf("promised", 3.0, 0.0),
                                   pointOf("some", 4.0, 1e-3)};
    points[1].views = 2;
    points[2].judged = false;
    const TradePlot plot(points, speed(), loss());
    EXPECT_EQ(plot.zeroLabel(loss()), "0") << "no number of views holds of all three";
    std::vector<std::string> names;
    for (const PlotMark& mark : plot.plot({}).marks) names.push_back(mark.name);
    EXPECT_THAT(names,
                testing::IsSupersetOf({"long: 0 (< 3/16)", "short: 0 of 2", "promised: 0 as promised, not judged", "some"}));
    EXPECT_EQ(tradeValueText(points[1], loss()), "0 of 2");
    EXPECT_EQ(TradePlot({points[1], points[3]}, speed(), loss()).zeroLabel(loss()), "0 of 2") << "not that of the lossy one";
    EXPECT_EQ(TradePlot({points[2], points[3]}, speed(), loss()).zeroLabel(loss()), "0") << "nothing was judged there";
}

TEST(TradePlot, aQuantileOfZeroIsNoBoundOfLosses) {
    TradePoint point = pointOf("some", 1.0, 1e-3);
    point.values["image_difference_p99"] = plain(0.0);
    const TradeFigure& quantile = tradeFigure("image_difference_p99");
    EXPECT_EQ(TradePlot({point}, speed(), quantile).zeroLabel(quantile), "0");
    EXPECT_EQ(tradeValueText(point, quantile), "0.000");
    const TradeFigure& share = tradeFigure("object_false_negative_rate");
    point.values[share.key] = plain(0.25);
    EXPECT_EQ(TradePlot({point}, speed(), share).plot({}).y.ticks.back().label, "100") << "no axis of percentages goes beyond";
}

TEST(TradePlot, eitherAxisMayBeByDecades) {
    const TradePlot plot({pointOf("none", 1.0, 0.0), pointOf("some", 2.0, 1e-3)}, loss(), speed());
    EXPECT_DOUBLE_EQ(plot.place(plot.points()[0]).x, -1.0);
    EXPECT_DOUBLE_EQ(plot.place(plot.points()[1]).x, 3.0);
    EXPECT_DOUBLE_EQ(plot.place(plot.points()[1]).y, 2.0);
}

TEST(TradePlot, frontsHoldWhatNothingSurpassesWithAndWithoutLoss) {
    std::vector<TradePoint> points{pointOf("slow", 1.0, 0.0),          pointOf("lossless", 2.0, 0.0),
                                   pointOf("careful", 2.5, 1e-6),      pointOf("behind", 2.4, 2e-6),
                                   pointOf("bold", 4.0, 1e-3),         pointOf("oracle", 9.0, 0.0),
                                   pointOf("equal to bold", 4.0, 1e-3)};
    points.push_back(pointOf("not judged", 5.0, 0.0));
    points.back().values.erase(kUsualUp);
    EXPECT_THAT(paretoFront(points, speed(), loss(), true), ElementsAre(1)) << "the limit is no strategy to choose";
    EXPECT_THAT(paretoFront(points, speed(), loss(), false), ElementsAre(2, 4, 6));
    const TradePlot plot(points, speed(), loss());
    EXPECT_EQ(plot.points().size(), 7u) << "what was not judged has no place";
    const LinePlot drawn = plot.plot({});
    const auto front = std::ranges::find(drawn.lines, std::string("front: something lost"), &PlotLine::name);
    ASSERT_NE(front, drawn.lines.end());
    EXPECT_EQ(front->points.size(), 5u) << "three points with a corner between each two";
}

TEST(TradePlot, everyMeasuredFigureMayBeAnAxisByItsNameInFiles) {
    EXPECT_GT(tradeFigures().size(), 20u);
    for (const TradeFigure& figure : tradeFigures()) EXPECT_EQ(&tradeFigure(figure.key), &figure);
    for (const FieldFigure& figure : fieldFigures()) EXPECT_NO_THROW((void)tradeFigure(figure.key)) << figure.key;
    try {
        (void)tradeFigure("beauty");
        FAIL() << "there is no such figure";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::Usage);
        EXPECT_THAT(error.message().english(), testing::HasSubstr("silhouette_error_px"));
    }
}

TEST(TradePlot, rowsOfASweepAreItsPoints) {
    ResultTable table = emptyTable(sweepExperiment({}));
    table.addRow({{"strategy", std::string("spherical")},
                  {"parameter", std::string("rows")},
                  {"value", std::string("45")},
                  {"promise", std::string("approximate")},
                  {"poses", 8.0},
                  {kUsualAcross, RatioEstimate{2.0, {1.5, 2.5}}},
                  {kUsualUp, RatioEstimate{1e-4, {1e-5, 1e-3}}}});
    table.addRow({{"strategy", std::string("backface")}, {"promise", std::string("conservative")}, {"poses", 8.0}});
    const std::vector<TradePoint> points = tradePoints(table);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].sweep, "spherical, rows");
    EXPECT_EQ(points[0].label, "45");
    EXPECT_EQ(points[0].name, "spherical rows=45");
    EXPECT_EQ(points[0].promise, Promise::Approximate);
    EXPECT_EQ(points[1].role, BaselineRole::FrontFaces);
    const TradePlot plot(points, speed(), loss());
    EXPECT_EQ(plot.points().size(), 1u) << "the other row has neither figure";
    EXPECT_EQ(tradeValueText(plot.points().front(), speed()), "2.00 [1.50, 2.50]");
    EXPECT_THAT(tradeCsv(points), testing::HasSubstr("spherical rows=45,approximate,8,2,1.5,2.5"));
}

}  // namespace
}  // namespace cullscope::test::trade_plot_test
