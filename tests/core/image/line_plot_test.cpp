#include "core/image/line_plot.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace cullscope::test::line_plot_test {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

LinePlot plotOf(std::vector<PlotPoint> points, PlotScale scale) {
    LinePlot plot;
    plot.title = "title";
    plot.x = {"across", scale};
    plot.y = {"up", scale};
    PlotLine line;
    line.name = "line";
    line.points = std::move(points);
    plot.lines = {line};
    return plot;
}

size_t countOf(const std::string& text, const std::string& part) {
    size_t count = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST(LinePlot, linearRangeIsRound) {
    const PlotRange range = rangeAlongX(plotOf({{3, 0}, {38, 0}}, PlotScale::Linear));
    EXPECT_THAT(range.ticks, ElementsAre(0, 5, 10, 15, 20, 25, 30, 35, 40));
    EXPECT_EQ(range.first, 0.0);
    EXPECT_EQ(range.last, 40.0);
    EXPECT_DOUBLE_EQ(range.share(10.0), 0.25);
}

TEST(LinePlot, givenRangeIsKeptAndWidenedByPoints) {
    LinePlot plot = plotOf({{3, 0}, {8, 0}}, PlotScale::Linear);
    plot.x.least = 1;
    plot.x.most = 40;
    PlotRange range = rangeAlongX(plot);
    EXPECT_EQ(range.first, 1.0);
    EXPECT_EQ(range.last, 40.0);
    EXPECT_THAT(range.ticks, ElementsAre(5, 10, 15, 20, 25, 30, 35, 40));
    plot.lines[0].points.push_back({50, 0});
    range = rangeAlongX(plot);
    EXPECT_EQ(range.last, 50.0) << "a point beyond it is not shown";
}

TEST(LinePlot, logarithmicRangeIsOfRoundNumbers) {
    const PlotRange narrow = rangeAlongY(plotOf({{1, 0.83}, {2, 33}}, PlotScale::Logarithmic));
    EXPECT_THAT(narrow.ticks, ElementsAre(DoubleNear(0.5, 1e-9), DoubleNear(1, 1e-9), DoubleNear(2, 1e-9), DoubleNear(5, 1e-9),
                                          DoubleNear(10, 1e-9), DoubleNear(20, 1e-9), DoubleNear(50, 1e-9)));
    EXPECT_NEAR(narrow.share(5.0), 0.5, 1e-9);
    const PlotRange wide = rangeAlongY(plotOf({{1, 1e4}, {2, 3e8}}, PlotScale::Logarithmic));
    EXPECT_THAT(wide.ticks, ElementsAre(DoubleNear(1e4, 1), DoubleNear(1e5, 1), DoubleNear(1e6, 1), DoubleNear(1e7, 1),
                                        DoubleNear(1e8, 1), DoubleNear(1e9, 1)));
    EXPECT_EQ(wide.ticks.size(), 6u);
}

TEST(LinePlot, rangeIsNeverEmpty) {
    for (const PlotScale scale : {PlotScale::Linear, PlotScale::Logarithmic})
        for (const std::vector<PlotPoint>& points :
             {std::vector<PlotPoint>{}, std::vector<PlotPoint>{{1, 1}}, std::vector<PlotPoint>{{7.3, 7.3}, {7.3, 7.3}},
              std::vector<PlotPoint>{{kNaN, kNaN}}, std::vector<PlotPoint>{{0, 0}}}) {
            const PlotRange range = rangeAlongY(plotOf(points, scale));
            EXPECT_LT(range.first, range.last);
            EXPECT_FALSE(range.ticks.empty());
            EXPECT_TRUE(std::isfinite(range.share(range.first)));
        }
}

TEST(LinePlot, zeroAndNotANumberBreakTheLineAndNotTheScale) {
    const LinePlot plot = plotOf({{1, 10}, {2, 0}, {3, kNaN}, {4, -5}, {5, 20}, {6, 40}}, PlotScale::Logarithmic);
    const PlotRange y = rangeAlongY(plot);
    EXPECT_NEAR(y.first, 10.0, 1e-9);
    EXPECT_NEAR(y.last, 50.0, 1e-9);
    const auto pieces = unbrokenPieces(plot.lines[0], rangeAlongX(plot), y);
    ASSERT_EQ(pieces.size(), 2u) << "the line runs through what has no place";
    EXPECT_EQ(pieces[0].size(), 1u);
    EXPECT_EQ(pieces[1].size(), 2u);
    const std::string svg = linePlotsSvg({plot});
    EXPECT_EQ(countOf(svg, "<polyline"), 2u);
    EXPECT_THAT(svg, Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
}

TEST(LinePlot, linearScaleTakesZeroAndLess) {
    const LinePlot plot = plotOf({{1, 0}, {2, -3}}, PlotScale::Linear);
    EXPECT_EQ(unbrokenPieces(plot.lines[0], rangeAlongX(plot), rangeAlongY(plot)).size(), 1u);
    EXPECT_LE(rangeAlongY(plot).first, -3.0);
}

TEST(LinePlot, numbersAreShortAndRight) {
    EXPECT_EQ(plotNumber(0.83), "0.83");
    EXPECT_EQ(plotNumber(0.1 + 0.2), "0.3");
    EXPECT_EQ(plotNumber(0.0), "0");
    EXPECT_EQ(plotNumber(-15.0), "-15");
    EXPECT_EQ(plotNumber(33.0), "33");
    EXPECT_EQ(plotNumber(1e4), "10000");
    EXPECT_EQ(plotNumber(1e6), "1e6");
    EXPECT_EQ(plotNumber(1e-6), "1e-6");
}

TEST(LinePlot, svgIsWellFormedAndItsTextEscaped) {
    LinePlot plot = plotOf({{1, 1}, {2, 20}}, PlotScale::Logarithmic);
    plot.title = "R < 3 & \"more\"";
    plot.references = {{"paper, mean:", 10}, {"nothing:", 0}};
    plot.lines[0].dashed = true;
    const std::string svg = linePlotsSvg({plot, plot});
    EXPECT_THAT(svg, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
    EXPECT_THAT(svg, HasSubstr(">R &lt; 3 &amp; \"more\"</text>"));
    EXPECT_EQ(countOf(svg, ">paper, mean: 10</text>"), 2u) << "once a plot";
    EXPECT_THAT(svg, Not(HasSubstr("nothing:"))) << "it has no place on the scale";
    EXPECT_EQ(countOf(svg, ">line</text>"), 2u);
    EXPECT_EQ(countOf(svg, ">across</text>"), 2u);
    EXPECT_EQ(countOf(svg, ">up</text>"), 2u);
    EXPECT_THAT(svg, HasSubstr("stroke-dasharray=\"7 4\""));
    EXPECT_EQ(countOf(svg, "<text"), countOf(svg, "</text>"));
    EXPECT_EQ(countOf(svg, "<"), countOf(svg, ">"));
    EXPECT_EQ(countOf(svg, "\"") % 2, 0u);
}

TEST(LinePlot, baselineIsGrey) {
    LinePlot plot = plotOf({{1, 1}, {2, 20}}, PlotScale::Linear);
    plot.lines.push_back(plot.lines[0]);
    plot.lines[0].baseline = true;
    plot.lines[1].colour = 0;
    const std::string svg = linePlotsSvg({plot});
    EXPECT_EQ(countOf(svg, "<polyline fill=\"none\" stroke=\"#555555\""), 1u);
    EXPECT_EQ(countOf(svg, "<polyline fill=\"none\" stroke=\"#0072b2\""), 1u);
}

TEST(LinePlot, exponentIsThePower) {
    std::vector<PlotPoint> points;
    for (const double x : {10.0, 300.0, 7000.0}) points.push_back({x, 3.0 * std::pow(x, 1.5)});
    EXPECT_NEAR(exponentOf(points), 1.5, 1e-12);
}

}  // namespace
}  // namespace cullscope::test::line_plot_test
