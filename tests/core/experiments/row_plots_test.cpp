#include "core/experiments/row_plots.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace cullscope::row_plots_test {
namespace {

/// Times of two methods over three sizes, of one shape, and one row of another; a time is missing.
ResultTable table() {
    ResultTable made;
    made.columns = {{"shape", ""}, {"method", ""}, {"size", ""}, {"ms", ""}, {"bytes", ""}};
    const std::string ball = "ball", cube = "cube", fast = "fast", slow = "slow";
    made.addRow({{"shape", ball}, {"method", fast}, {"size", 1.0}, {"ms", 1.0}, {"bytes", 8.0}});
    made.addRow({{"shape", ball}, {"method", slow}, {"size", 1.0}, {"ms", 2.0}, {"bytes", 8.0}});
    made.addRow({{"shape", ball}, {"method", fast}, {"size", 10.0}, {"ms", 10.0}, {"bytes", 80.0}});
    made.addRow(
        {{"shape", ball}, {"method", slow}, {"size", 10.0}, {"ms", RatioEstimate{200.0, {190.0, 210.0}}}, {"bytes", 80.0}});
    made.addRow({{"shape", ball}, {"method", fast}, {"size", 100.0}, {"bytes", 800.0}});
    made.addRow({{"shape", cube}, {"method", fast}, {"size", 5.0}, {"ms", 7.0}});
    return made;
}

RowPlot timeBySize() {
    RowPlot plot{logPlot("Time", "size", "ms")};
    plot.x = "size";
    plot.y = {{"ms"}};
    plot.lines = {"method"};
    plot.rows = {{"shape", {std::string("ball")}}};
    return plot;
}

TEST(RowPlots, rowsWithTheSameWordsAreALine) {
    const std::vector<LinePlot> plots = plotsOf(timeBySize(), table());
    ASSERT_EQ(plots.size(), 1u);
    EXPECT_EQ(plots[0].title, "Time");
    ASSERT_EQ(plots[0].lines.size(), 2u);
    EXPECT_EQ(plots[0].lines[0].name, "fast");
    EXPECT_EQ(plots[0].lines[0].points.size(), 2u) << "a row without a time is no point";
    EXPECT_EQ(plots[0].lines[1].name, "slow");
    EXPECT_EQ(plots[0].lines[1].points[1].x, 10.0);
    EXPECT_EQ(plots[0].lines[1].points[1].y, 200.0) << "a ratio is a number, too";
}

TEST(RowPlots, everyColumnIsALineOfEachGroup) {
    RowPlot plot = timeBySize();
    plot.y = {{"ms", "time"}, {"bytes", "bytes"}};
    const std::vector<LinePlot> plots = plotsOf(plot, table());
    std::vector<std::string> names;
    for (const PlotLine& line : plots[0].lines) names.push_back(line.name);
    EXPECT_THAT(names, testing::ElementsAre("fast: time", "fast: bytes", "slow: time", "slow: bytes"));
}

TEST(RowPlots, separatePlotsTakeTheirValuesIntoTheTitle) {
    RowPlot plot = timeBySize();
    plot.rows.clear();
    plot.separate = {"shape"};
    plot.plot.title = "Time of a %1";
    const std::vector<LinePlot> plots = plotsOf(plot, table());
    ASSERT_EQ(plots.size(), 2u);
    EXPECT_EQ(plots[0].title, "Time of a ball");
    EXPECT_EQ(plots[1].title, "Time of a cube");
    EXPECT_EQ(plots[1].heading.text, "Time of a %1");
    ResultTable none = table();
    none.rows.clear();
    EXPECT_EQ(plotsOf(plot, none).front().title, "Time of a …") << "before the first row";
    ASSERT_EQ(plots[1].lines.size(), 1u) << "a method that the cube has not is no line";
    EXPECT_EQ(plots[1].lines[0].points[0].y, 7.0);
}

TEST(RowPlots, pointsAreInTheRowsOrderOrInThatOfX) {
    ResultTable turned = table();
    std::ranges::reverse(turned.rows);
    const auto firstX = [&](const RowPlot& plot) { return plotsOf(plot, turned)[0].lines[0].points.front().x; };
    RowPlot plot = timeBySize();
    EXPECT_EQ(firstX(plot), 10.0);
    plot.byX = true;
    EXPECT_EQ(firstX(plot), 1.0);
}

TEST(RowPlots, powersBeginAtTheFirstPoint) {
    RowPlot plot = timeBySize();
    plot.powers = {{"as the square", 2.0}};
    plot.namesExponents = true;
    const std::vector<PlotLine> lines = plotsOf(plot, table())[0].lines;
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].name, "fast: power 1.00");
    EXPECT_EQ(lines[1].name, "slow: power 2.00");
    EXPECT_EQ(lines[2].name, "as the square");
    EXPECT_DOUBLE_EQ(lines[2].points[1].y, 100.0);
}

TEST(RowPlots, whatDoesNotGrowHasPowerZeroWithoutASign) {
    ResultTable table;
    for (const char* key : {"size", "ms"}) table.columns.push_back({key, key});
    table.addRow({{"size", 1.0}, {"ms", 1.0}});
    table.addRow({{"size", 10.0}, {"ms", 0.999}});
    RowPlot plot;
    plot.x = "size";
    plot.y = {{"ms", "time"}};
    plot.namesExponents = true;
    EXPECT_EQ(plotsOf(plot, table)[0].lines[0].name, "time: power 0.00");
}

TEST(RowPlots, cellsStandAtTheirPlacesInTheColourOfTheirStep) {
    ResultTable table;
    for (const char* key : {"d", "f", "v"}) table.columns.push_back({key, key});
    for (const double d : {1.0, 2.5, 6.0})
        for (const double f : {10.0, 90.0})
            if (d + f != 12.5) table.addRow({{"d", d}, {"f", f}, {"v", d * f / 540.0}});
    RowPlot described;
    described.x = "d";
    described.cellsOver = "f";
    described.y = {{"v"}};
    described.scale = 100.0;
    described.decimals = 0;
    const LinePlot plot = plotsOf(described, table).front();
    ASSERT_EQ(plot.x.ticks.size(), 3u);
    EXPECT_EQ(plot.x.ticks[1].label, "2.5");
    EXPECT_EQ(plot.y.ticks[1].value, 1.5);
    ASSERT_EQ(plot.bars.size(), 8u);
    size_t cells = 0;
    for (size_t step = 0; step < plot.bars.size(); ++step) {
        const PlotBars& bars = plot.bars[step];
        ASSERT_EQ(bars.boxes.size(), bars.labels.size());
        cells += bars.boxes.size();
        if (step > 0) EXPECT_NE(bars.colour, plot.bars[step - 1].colour);
        for (size_t i = 0; i < bars.boxes.size(); ++i) {
            const PlotBox& box = bars.boxes[i];
            const double d = std::array{1.0, 2.5, 6.0}[size_t(box.left)], f = std::array{10.0, 90.0}[size_t(box.bottom)];
            EXPECT_EQ(bars.labels[i], plotNumber(std::round(d * f / 5.4)));
            // From 10 / 540 to 540 / 540 in eight steps.
            const double share = (d * f - 10.0) / 530.0;
            EXPECT_EQ(step, std::min(size_t(share * 8.0 + 1e-9), size_t{7}));
        }
    }
    EXPECT_EQ(cells, 5u) << "what has no row has no cell";
}

TEST(RowPlots, cellsOfOneValueHaveOneColour) {
    ResultTable table;
    for (const char* key : {"d", "f", "v"}) table.columns.push_back({key, key});
    for (const double d : {1.0, 2.0}) table.addRow({{"d", d}, {"f", 1.0}, {"v", 0.0}});
    RowPlot described;
    described.x = "d";
    described.cellsOver = "f";
    described.y = {{"v"}};
    const LinePlot plot = plotsOf(described, table).front();
    ASSERT_EQ(plot.bars.size(), 1u);
    EXPECT_EQ(plot.bars.front().boxes.size(), 2u);
}

TEST(RowPlots, plotWithoutRowsHasItsAxes) {
    ResultTable empty = table();
    empty.rows.clear();
    const std::vector<LinePlot> plots = plotsOf(timeBySize(), empty);
    ASSERT_EQ(plots.size(), 1u);
    EXPECT_TRUE(plots[0].lines.empty());
    EXPECT_EQ(plots[0].x.title, "size");
}

TEST(RowPlots, pointsStayWithinTheRangeAndTheFilter) {
    RowPoints which{{{"method", {std::string("fast")}}}, "size", "bytes", 5.0};
    EXPECT_EQ(pointsOf(table(), which).size(), 2u);
    which.mostX = 50.0;
    EXPECT_EQ(pointsOf(table(), which).size(), 1u);
    which.rows["no such column"] = {1.0};
    EXPECT_TRUE(pointsOf(table(), which).empty());
}

}  // namespace
}  // namespace cullscope::row_plots_test
