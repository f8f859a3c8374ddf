// Flow charts of strategies, and their drawing.
#include "core/image/flow_chart_drawing.h"

#include <gtest/gtest.h>

#include <set>

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
