#include "core/experiments/reproduction_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace cullscope::reproduction_report_test {
namespace {

using testing::HasSubstr;
using testing::Not;

ReproductionReport smallReport() {
    ReproductionReport report;
    report.started = "2026-11-25 17:31 UTC";
    report.command = "cullbench reproduce all -o report.html";
    ResultTable table;
    table.experiment = "table-9";
    table.title = "Speed & <loss>";
    table.source = "A paper, Table 9";
    table.columns = {{"mesh", "mesh", ResultColumn::Origin::Axis},
                     {"fps", "paper: fps", ResultColumn::Origin::Stated, 1},
                     {"ratio", "× all", ResultColumn::Origin::Measured, 2},
                     {"unused", "of another form", ResultColumn::Origin::Measured}};
    table.addRow({{"mesh", std::string("<b>bunny</b>")}, {"fps", 12.5}, {"ratio", RatioEstimate{2.5, {2.25, 2.75}, true}}});
    table.checks = {{"is faster", 2.5, 1.0}, {"is as fast", 2.5, 0.0, 1.0}};
    LinePlot plot;
    plot.title = "Frames per second";
    plot.lines = {{"here", {{0.0, 1.0}, {1.0, 2.0}}}};
    table.plots = {plot};
    report.tables.push_back({table, "cullbench reproduce table-9"});
    report.figures.push_back({"A map", "A paper, Figure 1", "<svg></svg>", "cullbench figure 1 -o figure-1.svg"});
    return report;
}

TEST(ReproductionReport, sourceAndMeasurementStandBesideEachOtherOverTheirCommands) {
    const std::string html = reproductionHtml(smallReport());
    EXPECT_THAT(html, HasSubstr("<th class=\"stated\">source</th>"));
    EXPECT_THAT(html, HasSubstr("<td class=\"stated\">12.5</td>"));
    EXPECT_THAT(html, HasSubstr("2.50 [2.25,&nbsp;2.75]")) << "an interval stays on one line";
    EXPECT_THAT(html, Not(HasSubstr("of another form"))) << "a column without a value";
    EXPECT_THAT(html, HasSubstr("<pre>cullbench reproduce table-9</pre>"));
    EXPECT_THAT(html, HasSubstr("<pre>cullbench reproduce table-9 --svg table-9.svg</pre>"));
    EXPECT_THAT(html, HasSubstr("<pre>cullbench figure 1 -o figure-1.svg</pre>"));
    EXPECT_THAT(html, HasSubstr("<li class=\"held\">is faster"));
    EXPECT_THAT(html, HasSubstr("<li class=\"failed\">is as fast"));
    EXPECT_THAT(html, HasSubstr("PHN2Zz48L3N2Zz4=")) << "the figure stands in the page";
}

TEST(ReproductionReport, aTableOfManyColumnsIsPrintedSmaller) {
    EXPECT_THAT(reproductionHtml(smallReport()), HasSubstr("<table>\n<thead>"));
    ReproductionReport report = smallReport();
    ResultTable& table = report.tables[0].table;
    table.columns.clear();
    table.rows.clear();
    for (int i = 0; i < 24; ++i) table.columns.push_back({std::to_string(i), "figure"});
    Row row;
    for (int i = 0; i < 24; ++i) row[std::to_string(i)] = double(i);
    table.addRow(row);
    EXPECT_THAT(reproductionHtml(report), HasSubstr("<table class=\"many\">\n<thead>"));
}

TEST(ReproductionReport, needsNothingBesideItAndTakesWordsAsWords) {
    ReproductionReport report = smallReport();
    const std::string html = reproductionHtml(report);
    EXPECT_THAT(html, HasSubstr("&lt;b&gt;bunny&lt;/b&gt;"));
    EXPECT_THAT(html, HasSubstr("Speed &amp; &lt;loss&gt;"));
    for (const char* other : {"http:", "https:", "<script", "<link", "url(", "@import"}) EXPECT_THAT(html, Not(HasSubstr(other)));
    EXPECT_THAT(html, Not(HasSubstr("Not complete")));
    report.complete = false;
    report.missing = {{"There is no bunny.", {}}};
    EXPECT_THAT(reproductionHtml(report), testing::AllOf(HasSubstr("Not complete"), HasSubstr("There is no bunny.")));
}

}  // namespace
}  // namespace cullscope::reproduction_report_test
