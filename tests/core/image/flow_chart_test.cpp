// Flow charts of strategies, and their drawing.
#include "core/image/flow_chart_drawing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

#include "core/image/drawing_svg.h"
#include "core/visibility/registry.h"

namespace cullscope::test::flow_chart_test {
namespace {

std::string english(const std::string& text) { return text; }

const FlowChart& chartOfSpherical() { return findStrategy("spherical").info.first(Show::Kind::Listing)->chart; }

/// The filled paths in a colour.
size_t filled(const PlotDrawing& drawing, PlotColour colour) {
    size_t count = 0;
    for (const auto& item : drawing.items)
        if (const auto* path = std::get_if<DrawnPath>(&item)) count += path->fill == colour ? 1 : 0;
    return count;
}

TEST(FlowChart, everyLineOfTheListingHasOneBox) {
    size_t charts = 0;
    for (const RegisteredStrategy& strategy : strategies()) {
        const Show* listing = strategy.info.first(Show::Kind::Listing);
        if (listing == nullptr || listing->chart.empty()) continue;
        ++charts;
        std::multiset<uint8_t> lines;
        for (const FlowBox& box : listing->chart.boxes) lines.insert(box.lines.begin(), box.lines.end());
        for (uint8_t line = 1; line <= listing->lines.size(); ++line)
            EXPECT_EQ(lines.count(line), 1u) << strategy.info.id << ", line " << int(line);
        EXPECT_EQ(lines.size(), listing->lines.size());
        for (const FlowArrow& arrow : listing->chart.arrows) {
            ASSERT_LT(arrow.from, listing->chart.boxes.size());
            ASSERT_LT(arrow.to, listing->chart.boxes.size());
        }
    }
    EXPECT_GE(charts, 1u);
}

TEST(FlowChart, boxOfTheCurrentLineAloneIsLit) {
    const FlowChart& chart = chartOfSpherical();
    const PlotStyle style = svgStyle();
    const FlowColours colours;
    double height = 0.0;
    EXPECT_EQ(filled(drawFlowChart(chart, 0, 700.0, height, style, colours, english), colours.lit), 0u);
    for (uint8_t line = 1; line <= 10; ++line)
        EXPECT_EQ(filled(drawFlowChart(chart, line, 700.0, height, style, colours, english), colours.lit), 1u) << int(line);
}

/// A log whose decisions fell at these lines.
FrameLog logAt(const std::vector<uint8_t>& lines) {
    FrameLog log;
    for (const uint8_t line : lines) log.decisions.emplace_back().line = line;
    return log;
}

TEST(FlowChart, wayLeadsPastTheBoxesOfTheDecisionsAndTheQuestionsBetweenThem) {
    const FlowChart& chart = chartOfSpherical();
    const auto arrowsOf = [&](const FlowWay& way) {
        std::set<std::pair<size_t, size_t>> arrows;
        for (size_t i = 0; i < chart.arrows.size(); ++i)
            if (way.passesArrow(i)) arrows.insert({chart.arrows[i].from, chart.arrows[i].to});
        return arrows;
    };
    // The boxes in their order: vertices, maps, sphere, outside, around, inside?, rays, search, hit?, region, boxes, bands, draw,
    // pipeline.
    const std::set<std::pair<size_t, size_t>> toQuestion{{0, 1}, {1, 2}, {2, 5}};
    auto hits = toQuestion, misses = toQuestion, inside = toQuestion;
    hits.insert({{5, 6}, {6, 7}, {7, 8}, {8, 9}, {9, 10}, {10, 13}});
    misses.insert({{5, 6}, {6, 7}, {7, 8}, {8, 11}, {11, 12}, {12, 13}});
    inside.insert({{5, 11}, {11, 12}, {12, 13}});
    EXPECT_EQ(arrowsOf(flowWay(chart, logAt({1, 2, 5, 6, 6, 7, 8}), true)), hits);
    EXPECT_EQ(arrowsOf(flowWay(chart, logAt({1, 2, 5, 6, 9, 10}), true)), misses);
    EXPECT_EQ(arrowsOf(flowWay(chart, logAt({1, 2, 9, 9, 10}), true)), inside);
    hits.erase({10, 13});
    EXPECT_EQ(arrowsOf(flowWay(chart, logAt({1, 2, 5, 6, 6, 7, 8}), false)), hits) << "before the frame has ended";
    const FlowWay none = flowWay(chart, logAt({}), false);
    EXPECT_EQ(std::ranges::count(none.boxes, true), 0);
    // A second object begins anew at its sphere: no arrow leads back there.
    EXPECT_EQ(arrowsOf(flowWay(chart, logAt({1, 2, 3, 2, 4}), true)),
              (std::set<std::pair<size_t, size_t>>{{0, 1}, {1, 2}, {2, 3}, {2, 4}}));
}

TEST(FlowChart, passedBoxesAreDrawnInTheirColour) {
    const FlowChart& chart = chartOfSpherical();
    const FlowColours colours;
    double height = 0.0;
    const FlowWay way = flowWay(chart, logAt({1, 2, 5}), false);
    const PlotDrawing drawing = drawFlowChart(chart, 5, 700.0, height, svgStyle(), colours, english, way);
    EXPECT_EQ(filled(drawing, colours.lit), 1u);
    EXPECT_EQ(filled(drawing, colours.passed), size_t(std::ranges::count(way.boxes, true)) - 1) << "all but the one in hand";
}

TEST(FlowChart, wordsStayWithinTheWidthAndTheHeight) {
    const FlowChart& chart = chartOfSpherical();
    const PlotStyle style = svgStyle();
    for (const double width : {420.0, 700.0, 1200.0}) {
        double height = 0.0;
        const PlotDrawing drawing = drawFlowChart(chart, 5, width, height, style, {}, english);
        for (const auto& item : drawing.items) {
            const auto* text = std::get_if<DrawnText>(&item);
            if (text == nullptr) continue;
            const double wide = style.width(text->words);
            const double left = text->anchor == TextAnchor::Start    ? text->at.x
                                : text->anchor == TextAnchor::Middle ? text->at.x - wide / 2
                                                                     : text->at.x - wide;
            EXPECT_GE(left, 0.0) << text->words << " in " << width;
            EXPECT_LE(left + wide, width) << text->words << " in " << width;
            EXPECT_LE(text->at.y, height) << text->words << " in " << width;
        }
    }
}

}  // namespace
}  // namespace cullscope::test::flow_chart_test
