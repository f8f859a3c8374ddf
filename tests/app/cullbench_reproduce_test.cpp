// The command line's contract (docs/command-line.md) for experiments of papers: their list, and the results of repeating one.

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_reproduce_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST_F(CullbenchContract, listShowsEveryExperiment) {
    const json root = json::parse(cullbench({"list", "experiments", "--json"}).out);
    std::vector<std::string> experiments;
    for (const json& each : root["experiments"]) experiments.push_back(each["id"]);
    EXPECT_THAT(experiments,
                testing::ElementsAre("table-1", "table-2", "table-3", "table-4", "table-5", "table-1-layouts", "table-2-views",
                                     "spherical-readings", "spherical-domain", "vfc-40-views", "vfc-fitted-views",
                                     "lecture-table", "quiz", "example", "bsp-planes", "plant-methods", "plant-pipelines",
                                     "plant-losses", "occlusion-growth", "occlusion-sizes"));
    const std::string text = cullbench({"list", "experiments"}).out;
    for (const std::string& id : experiments) EXPECT_THAT(text, HasSubstr(id));
}

TEST_F(CullbenchContract, reproduceRefusesUnknownExperimentsAndBadOptions) {
    expectRefusal(cullbench({"reproduce", "table-9"}), 2,
                  "Known: table-1, table-2, table-3, table-4, table-5, table-1-layouts, table-2-views, spherical-readings, "
                  "spherical-domain, "
                  "vfc-40-views, vfc-fitted-views, lecture-table, quiz, example, bsp-planes, "
                  "plant-methods, plant-pipelines, plant-losses, occlusion-growth, occlusion-sizes.");
    expectRefusal(cullbench({"reproduce"}), 2, "EXPERIMENT");
    expectRefusal(cullbench({"reproduce", "table-1", "--repeat", "0"}), 2, "--repeat");
    expectRefusal(cullbench({"reproduce", "table-1", "--json", file("none/t.json")}), 2, "t.json");
    expectRefusal(cullbench({"reproduce", "table-1", "--svg", file("t.svg")}), 2,
                  "no plot. With a plot: spherical-domain, vfc-40-views, vfc-fitted-views, lecture-table, plant-methods, "
                  "plant-pipelines, plant-losses, occlusion-growth, occlusion-sizes.");
    expectRefusal(cullbench({"reproduce", "table-1", "--png", file("t.png")}), 2, "--png: table-1 has a table and no plot");
    expectRefusal(cullbench({"reproduce", "vfc-40-views", "--png", file("t.bmp")}), 2, ".png");
    expectRefusal(cullbench({"reproduce", "vfc-40-views", "--svg", file("none/t.svg")}), 2, "t.svg");
    expectRefusal(cullbench({"reproduce", "vfc-40-views", "--svg", "-", "--json", "-"}), 2, "--json and --svg");
    expectRefusal(cullbench({"reproduce", "all", "--csv", file("t.csv")}), 2, "--csv has the rows of one experiment");
    EXPECT_EQ(filesWritten(), 0u);
}

TEST_F(CullbenchContract, helpOfReproduceNamesEveryExperimentThatTakesAScene) {
    const std::string help = cullbench({"reproduce", "--help"}).out;
    const std::string refusal = cullbench({"reproduce", "vfc-40-views", "torus"}).err, before = "Taking one: ";
    const size_t first = refusal.find(before);
    ASSERT_NE(first, std::string::npos) << refusal;
    const std::string taking = refusal.substr(first + before.size(), refusal.find('.', first) - first - before.size());
    EXPECT_THAT(taking, HasSubstr("table-2, "));
    EXPECT_THAT(help, HasSubstr(taking));
}

TEST_F(CullbenchContract, reportOfAFailedReproductionReplacesNoOlderOne) {
    std::ofstream(file("old.html")) << "an older report";
    for (const char* experiment : {"table-2", "quiz"})
        EXPECT_EQ(cullbench({"reproduce", experiment, file("nosuch.ply"), "-o", file("old.html")}).exitStatus, 3) << experiment;
    std::ifstream in(file("old.html"));
    EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "an older report");
    const ProcessResult untimed = cullbench({"reproduce", "quiz", "--store", file("s"), "-o", file("old.html")});
    EXPECT_EQ(untimed.exitStatus, 0) << untimed.err;
    EXPECT_THAT(untimed.err, HasSubstr("times no frames"));
}

TEST_F(CullbenchContract, reproduceWritesTheRowsOfOneExperimentAsCsv) {
    const ProcessResult result = cullbench({"reproduce", "quiz", "--csv", "-", "--json", file("t.json")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    std::ifstream in(file("t.json"));
    const json table = json::parse(in)["experiments"][0];
    std::string header;
    for (const json& column : table["columns"]) header += (header.empty() ? "" : ",") + column["key"].get<std::string>();
    EXPECT_THAT(result.out, testing::StartsWith(header + "\n"));
    EXPECT_EQ(size_t(std::ranges::count(result.out, '\n')), table["rows"].size() + 1);
}

TEST_F(CullbenchContract, reproduceNeedsNoOpenGlForTheStructures) {
    const ProcessResult result =
        cullbench({"reproduce", "table-1", "--json", "-"}, {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent/egl.json"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    const json table = json::parse(result.out)["experiments"][0];
    EXPECT_EQ(table["scene"]["triangles"], 144046);
    ASSERT_EQ(table["rows"].size(), 5u);
    EXPECT_EQ(table["rows"][2]["paper_megabytes"], 6.7);
    // The limit required for the three maps at the paper's resolution, in megabytes.
    EXPECT_LE(table["rows"][4]["megabytes"], 8.0);
    EXPECT_GT(table["rows"][4]["build_ms"], 0.0);
    EXPECT_THAT(result.err, HasSubstr("memory access map")) << "the table itself goes beside the data";
}

TEST_F(CullbenchContract, reproduceGivesThePapersAndOurFigures) {
    const ProcessResult result = cullbench({"reproduce", "table-2", "--repeat", "1", "--json", file("t.json")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("13508"));
    std::ifstream in(file("t.json"));
    const json table = json::parse(in)["experiments"][0];
    ASSERT_EQ(table["rows"].size(), 48u) << "four lenses";
    const std::array<double, 3> considered{13508.0, 16434.0, 26308.0};
    for (int number = 1; number <= 3; ++number) {
        const json& spherical = table["rows"][size_t(4 * number - 2)];
        EXPECT_NEAR(spherical["considered_triangles"].get<double>() / considered[size_t(number - 1)], 144046.0 / 144078.0, 0.05);
        EXPECT_GE(spherical["rays_hit"], 1.0);
        EXPECT_EQ(spherical["strategy"], "spherical");
        EXPECT_EQ(spherical["case"], number);
        EXPECT_EQ(spherical["cases"], std::to_string(number) + " ×" + std::to_string(spherical["poses"].get<int>()));
        EXPECT_GE(spherical["poses"], 10);
        EXPECT_GT(spherical["ratio_to_all"], 0.0);
        EXPECT_GT(spherical["ratio_to_backface"], 0.0);
        EXPECT_GE(spherical["missed_pixels"], 0.0);
        const json& limit = table["rows"][size_t(4 * number - 1)];
        EXPECT_EQ(limit["strategy"], "oracle");
        EXPECT_EQ(limit["missed_pixels"], 0.0);
        // Null where times are so noisy that nothing is left to gain for certain.
        ASSERT_TRUE(limit.contains("headroom_share"));
        if (!limit["headroom_share"].is_null()) EXPECT_DOUBLE_EQ(limit["headroom_share"], 1.0);
    }
}

TEST_F(CullbenchContract, quizTakesAFileOfTheLecturersOwn) {
    std::ofstream(file("own.polygons")) << "polygon A 1 0 0  2 0 0  2 1 0\nplane P 1 0 0 0\neye 5 1 5\n";
    const ProcessResult result = cullbench({"reproduce", "quiz", file("own.polygons")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, testing::AllOf(HasSubstr("C2"), HasSubstr("NULL"), HasSubstr("order")));
    EXPECT_THAT(result.out, testing::Not(HasSubstr("answer key")));
    for (const char* experiment : {"bsp-planes", "all"})
        expectRefusal(
            cullbench({"reproduce", experiment, file("own.polygons")}), 2,
            "Taking one: table-1, table-2, table-3, table-4, table-5, table-1-layouts, table-2-views, spherical-readings, "
            "spherical-domain, quiz, example, plant-losses, occlusion-growth.");
    std::ofstream(file("own.polygons")) << "plane P 1 0 0 0\n";
    expectRefusal(cullbench({"reproduce", "quiz", file("own.polygons")}), 3, "own.polygons names no polygon");
}

TEST_F(CullbenchContract, interruptBeforeTheFirstRowWritesNoTable) {
    const ProcessResult result = cullbench({"reproduce", "table-3", "--json", file("t.json")}, {}, 1.0);
    EXPECT_EQ(result.exitStatus, 130) << result.err;
    EXPECT_THAT(result.err, HasSubstr("before anything was measured"));
    EXPECT_EQ(filesWritten(), 0u);
}

/// All 40 views take a minute: a few of them are enough for the files. (cho_figure_6_test checks the rows and lines.)
TEST_F(CullbenchContract, interruptKeepsTheFiguresViews) {
    // On a busy machine the first views take longer than on a quiet one.
    for (double seconds = 5.0; seconds <= 80.0 && !std::filesystem::exists(file("f.json")); seconds *= 2.0) {
        const ProcessResult result = cullbench({"reproduce", "vfc-40-views", "--repeat", "1", "--json", file("f.json"), "--svg",
                                                file("f.svg"), "-o", file("f.html")},
                                               {}, seconds);
        EXPECT_EQ(result.exitStatus, 130) << result.err;
    }
    std::ifstream in(file("f.json"));
    const json table = json::parse(in)["experiments"][0];
    EXPECT_TRUE(table["interrupted"]);
    ASSERT_EQ(table["plots"].size(), 1u);
    for (const char* field : {"title", "x", "y", "lines", "references"}) EXPECT_TRUE(table["plots"][0].contains(field)) << field;
    EXPECT_EQ(table["plots"][0]["references"].size(), 3u);
    std::ifstream svg(file("f.svg"));
    std::string text((std::istreambuf_iterator<char>(svg)), std::istreambuf_iterator<char>());
    EXPECT_THAT(text, testing::StartsWith("<svg"));
    EXPECT_THAT(text, HasSubstr("Frames per second by viewpoint"));
    EXPECT_THAT(text, testing::EndsWith("</svg>\n"));
    std::ifstream html(file("f.html"));
    const std::string report((std::istreambuf_iterator<char>(html)), std::istreambuf_iterator<char>());
    EXPECT_THAT(report, testing::AllOf(HasSubstr("Not complete"), HasSubstr("Stopped early"),
                                       HasSubstr("<pre>cullbench reproduce vfc-40-views --repeat 1</pre>"),
                                       HasSubstr("src=\"data:image/svg+xml;base64,"), testing::EndsWith("</html>\n")));
}

TEST_F(CullbenchContract, commandsOfAReportFindTheModelsThatItFound) {
    const std::string folder = file("my models");
    std::filesystem::create_directory(folder);
    ASSERT_EQ(
        cullbench({"--models", folder, "reproduce", "table-1", "star:seed=7,triangles=500", "-o", file("m.html")}).exitStatus, 0);
    std::ifstream html(file("m.html"));
    const std::string report((std::istreambuf_iterator<char>(html)), std::istreambuf_iterator<char>());
    EXPECT_THAT(report, testing::ContainsRegex(
                            "<pre>cullbench --models [^<]*my models[^<]* reproduce table-1 star:seed=7,triangles=500</pre>"));
}

}  // namespace
}  // namespace cullscope::test::cullbench_reproduce_test
