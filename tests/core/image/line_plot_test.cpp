#include "core/image/line_plot.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/image/plot_drawing.h"

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

/// Letters of 6 pixels, lines of 12.
PlotStyle plainStyle() {
    PlotStyle style;
    style.series = plotSeries(false);
    style.ascent = 10.0;
    style.height = 12.0;
    style.width = [](const std::string& words) { return 6.0 * double(words.size()); };
    style.number = plotNumber;
    return style;
}

template <typename Item>
std::vector<Item> itemsOf(const PlotDrawing& drawing) {
    std::vector<Item> items;
    for (const auto& item : drawing.items)
        if (const auto* one = std::get_if<Item>(&item)) items.push_back(*one);
    return items;
}

/// Paths of a colour, that of the legend included.
size_t pathsOf(const PlotDrawing& drawing, PlotColour colour) {
    const std::vector<DrawnPath> paths = itemsOf<DrawnPath>(drawing);
    return size_t(std::count_if(paths.begin(), paths.end(), [&](const DrawnPath& path) { return path.pen.colour == colour; }));
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
    const PlotDrawing drawing = drawPlots({plot}, 600, 300, plainStyle());
    EXPECT_EQ(pathsOf(drawing, plotSeries(false)[0]), 2u) << "the second piece, and the legend";
    EXPECT_EQ(itemsOf<DrawnDisc>(drawing).size(), 3u) << "a point alone is no line";
    const std::string svg = linePlotsSvg({plot});
    EXPECT_THAT(svg, Not(testing::AnyOf(HasSubstr("nan"), HasSubstr("inf"))));
}

TEST(LinePlot, linearScaleTakesZeroAndLess) {
    const LinePlot plot = plotOf({{1, 0}, {2, -3}}, PlotScale::Linear);
    EXPECT_EQ(unbrokenPieces(plot.lines[0], rangeAlongX(plot), rangeAlongY(plot)).size(), 1u);
    EXPECT_LE(rangeAlongY(plot).first, -3.0);
}

TEST(LinePlot, fewTicksAreRound) {
    const PlotRange linear = rangeAlongY(plotOf({{1, 0}, {2, 10}}, PlotScale::Linear));
    EXPECT_EQ(linear.fewTicks(9), linear.ticks);
    EXPECT_THAT(linear.fewTicks(4), ElementsAre(0, 5, 10));
    EXPECT_THAT(linear.fewTicks(2), ElementsAre(0, 10));
    PlotRange low = linear;
    for (const double last : {0.95, 0.45, 2.9, 0.6}) {
        low.last = last;
        low.ticks = {0.0, last / 4, last / 2, last * 3 / 4};
        EXPECT_EQ(low.fewTicks(2).size(), 2u) << last << ": one number alone would be no scale";
    }
    low.last = 0.95;
    EXPECT_THAT(low.fewTicks(2), ElementsAre(0, 0.5));
    const PlotRange decades = rangeAlongY(plotOf({{1, 1}, {2, 1000}}, PlotScale::Logarithmic));
    EXPECT_THAT(decades.fewTicks(5), ElementsAre(1, 10, 100, 1000)) << "2 and 5 between them";
    EXPECT_THAT(decades.fewTicks(2), ElementsAre(1, 100));
}

TEST(LinePlot, numbersAreShortAndRight) {
    EXPECT_EQ(plotNumber(0.83), "0.83");
    EXPECT_EQ(plotNumber(0.1 + 0.2), "0.3");
    EXPECT_EQ(plotNumber(0.0), "0");
    EXPECT_EQ(plotNumber(-15.0), "-15");
    EXPECT_EQ(plotNumber(2e6), "2e6");
    EXPECT_EQ(plotNumber(2.5e-7), "2.5e-7");
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

TEST(LinePlot, svgHasNoControlCharacters) {
    LinePlot plot = plotOf({{1, 1}, {2, 20}}, PlotScale::Linear);
    plot.title = "a\x1B[0m\nb\x7F";
    EXPECT_THAT(linePlotsSvg({plot}), HasSubstr(">a?[0m?b?</text>"));
}

TEST(LinePlot, baselineIsGrey) {
    LinePlot plot = plotOf({{1, 1}, {2, 20}}, PlotScale::Linear);
    plot.lines.push_back(plot.lines[0]);
    plot.lines[0].baseline = true;
    plot.lines[1].colour = 0;
    const PlotStyle style = plainStyle();
    const PlotDrawing drawing = drawPlots({plot}, 600, 300, style);
    // The curve and the legend's piece of it; the axes are as grey as the baseline.
    EXPECT_EQ(pathsOf(drawing, style.series[0]), 2u);
    EXPECT_EQ(pathsOf(drawing, style.faint), 3u);
    EXPECT_EQ(countOf(linePlotsSvg({plot}), "stroke=\"#0072b2\""), 2u);
}

/// The plots of this file at once: levels, bars, marks with labels, long names.
LinePlot fullPlot() {
    LinePlot plot = plotOf({{1, 1}, {2, 20}, {4, 7}}, PlotScale::Linear);
    plot.y.title = "a caption of so many words that it takes more than one line in a narrow plot";
    plot.references = {{"level:", 12}};
    plot.bars = {{"area", 0xFF112233, {{0, 4, 2, 0}}}};
    plot.marks = {{"mark", {3, 5}, PlotShape::Triangle, {0xFF000000}, 0xFFFF0000, "label"},
                  {"shape", kNoPlace, PlotShape::Disc, {0xFF00FF00}, 0, ""}};
    return plot;
}

TEST(PlotDrawing, noTextIsCutOrLiesOverOtherText) {
    LinePlot plot = fullPlot();
    for (int i = 0; i < 12; ++i) plot.lines.push_back(plot.lines[0]);
    const PlotStyle style = plainStyle();
    for (const double width : {260.0, 500.0, 700.0, 1100.0})
        for (const std::vector<LinePlot>& plots : {std::vector{plot}, std::vector{plot, plot}}) {
            const double height = neededHeight(plots, width, style);
            std::vector<PlotBox> boxes;
            for (const DrawnText& text : itemsOf<DrawnText>(drawPlots(plots, width, height, style))) {
                const double wide = style.width(text.words) / (text.bold ? 1.0 / 1.1 : 1.0);
                const double left = text.at.x - wide * (text.anchor == TextAnchor::Start ? 0.0
                                                        : text.anchor == TextAnchor::End ? 1.0
                                                                                         : 0.5);
                boxes.push_back({left, text.at.y - style.ascent, left + wide, text.at.y - style.ascent + style.height});
                const PlotBox& box = boxes.back();
                EXPECT_TRUE(box.left >= 0 && box.top >= 0 && box.right <= width && box.bottom <= height)
                    << text.words << " in " << width << " x " << height;
            }
            for (size_t i = 0; i < boxes.size(); ++i)
                for (size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(boxes[i].left < boxes[j].right && boxes[j].left < boxes[i].right &&
                                 boxes[i].top < boxes[j].bottom - 0.5 && boxes[j].top < boxes[i].bottom - 0.5)
                        << j << " and " << i << " in " << width;
        }
}

TEST(PlotDrawing, shapeWithoutAPlaceIsInTheLegendAlone) {
    const PlotDrawing drawing = drawPlots({fullPlot()}, 600, 300, plainStyle());
    const std::vector<DrawnDisc> discs = itemsOf<DrawnDisc>(drawing);
    EXPECT_EQ(std::count_if(discs.begin(), discs.end(), [](const DrawnDisc& disc) { return disc.pen.colour == 0xFF00FF00; }), 1);
    EXPECT_EQ(pathsOf(drawing, 0xFF000000), 2u) << "the triangle and its key";
    for (const char* name : {"mark", "shape", "area", "line", "level: 12", "label"}) {
        const std::vector<DrawnText> texts = itemsOf<DrawnText>(drawing);
        EXPECT_EQ(std::count_if(texts.begin(), texts.end(), [&](const DrawnText& text) { return text.words == name; }), 1)
            << name;
    }
}

TEST(PlotDrawing, valuesStandBesideTheirTicks) {
    const PlotDrawing drawing = drawPlots({fullPlot()}, 600, 300, plainStyle());
    ASSERT_EQ(drawing.places.size(), 1u);
    const PlotPlace& place = drawing.places[0];
    EXPECT_EQ(place.x.first, 0.0) << "the area begins there";
    EXPECT_EQ(place.pixel({place.x.first, place.y.last}).x, place.box.left);
    EXPECT_EQ(place.pixel({place.x.first, place.y.last}).y, place.box.top);
    EXPECT_EQ(place.pixel({place.x.last, place.y.first}).x, place.box.right);
    EXPECT_EQ(place.pixel({place.x.last, place.y.first}).y, place.box.bottom);
    for (const DrawnText& text : itemsOf<DrawnText>(drawing))
        if (text.words == "3") {
            EXPECT_NEAR(text.at.x, place.pixel({3, 0}).x, 1e-9);
        }
}

TEST(PlotDrawing, longChineseCaptionIsWrapped) {
    LinePlot plot = fullPlot();
    plot.y.title = "每个扇区单独比较，两种颜色的环带在一些扇区中绘制";
    const std::vector<DrawnText> texts = itemsOf<DrawnText>(drawPlots({plot}, 300, 300, plainStyle()));
    std::string joined;
    for (const DrawnText& text : texts)
        if (text.at.x < 5.0 && plot.y.title.find(text.words) != std::string::npos) joined += text.words;
    EXPECT_EQ(joined, plot.y.title);
    EXPECT_NE(texts[1].words, plot.y.title);
}

TEST(PlotDrawing, ticksOfWholeNumbersAreWhole) {
    LinePlot plot = plotOf({{0, 0}, {3, 0}}, PlotScale::Linear);
    plot.x.whole = plot.y.whole = plot.y.zero = true;
    EXPECT_THAT(rangeAlongX(plot).ticks, ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(rangeAlongY(plot).ticks, ElementsAre(0, 1)) << "nothing but zeros";
}

TEST(PlotDrawing, namedTicksDoNotOverlapHoweverLowThePlotIs) {
    // As the poses of a measurement have them: two upwards, three close to each other below.
    LinePlot plot = plotOf({{0, 1}, {3, -0.5}}, PlotScale::Linear);
    plot.y.ticks = {{1.0, "top"}, {0.5, "half"}, {-0.5, "last"}, {-0.17, "first"}, {-0.33, "middle"}};
    const PlotStyle style = plainStyle();
    size_t fewest = 5, most = 0;
    for (double height = neededHeight({plot}, 500.0, style); height < 400.0; height += 7.0) {
        std::vector<double> tops;
        std::vector<std::string> words;
        for (const DrawnText& text : itemsOf<DrawnText>(drawPlots({plot}, 500.0, height, style)))
            if (std::ranges::find(plot.y.ticks, text.words, &PlotTick::label) != plot.y.ticks.end()) {
                for (const double top : tops)
                    EXPECT_GE(std::abs(top - text.at.y), style.height) << text.words << " at " << height;
                tops.push_back(text.at.y);
                words.push_back(text.words);
            }
        EXPECT_THAT(words, testing::IsSupersetOf({"top", "last"})) << "the former ones come first, at " << height;
        fewest = std::min(fewest, words.size());
        most = std::max(most, words.size());
    }
    EXPECT_LT(fewest, 5u) << "else none was too low";
    EXPECT_EQ(most, 5u);
}

TEST(LinePlot, exponentIsThePower) {
    std::vector<PlotPoint> points;
    for (const double x : {10.0, 300.0, 7000.0}) points.push_back({x, 3.0 * std::pow(x, 1.5)});
    EXPECT_NEAR(exponentOf(points), 1.5, 1e-12);
}

}  // namespace
}  // namespace cullscope::test::line_plot_test
