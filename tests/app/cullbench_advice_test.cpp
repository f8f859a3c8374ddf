// The command line's contract (docs/command-line.md) for advise, race, worst and the axes of sweep's plot.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_advice_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string contentsOf(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

const std::string kSmall = "star:seed=7,triangles=500";

TEST_F(CullbenchContract, adviceNamesAStrategyAndWhatItCosts) {
    const ProcessResult result = cullbench(
        {"advise", kSmall, "--path", "fibonacci:2", "--size", "64x48", "--json", file("a.json"), "--svg", file("a.svg")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("best here"));
    const json advice = json::parse(contentsOf(file("a.json")));
    EXPECT_TRUE(advice["recommended"].is_string());
    EXPECT_EQ(advice["strategies"][0]["strategy"], advice["recommended"]);
    EXPECT_EQ(advice["strategies"][0]["lost_pixels"], 0);
    EXPECT_TRUE(advice["strategies"][0]["promise"].is_string());
    for (const json& each : advice["strategies"]) {
        // What was not built has no promise and no structure that were known.
        EXPECT_EQ(each["promise"].is_null(), each["structure_bytes"].is_null()) << each;
        if (each["promise"].is_null()) EXPECT_EQ(each["views"], 0) << each;
    }
    EXPECT_THAT(contentsOf(file("a.svg")), HasSubstr("Speed against drawing everything"));
    expectRefusal(cullbench({"advise", kSmall, "--max-missed", "2"}), 2, "--max-missed");
    expectRefusal(cullbench({"advise", kSmall, "--path", "nowhere:2"}), 2, "nowhere");
}

TEST_F(CullbenchContract, raceComparesEachWithEach) {
    const ProcessResult result = cullbench({"race", kSmall, "-s", "all,backface,frustum", "--path", "fibonacci:2", "--size",
                                            "64x48", "--repeat", "1", "--csv", file("r.csv"), "--json", file("r.json")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("frustum"));
    const std::string csv = contentsOf(file("r.csv"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7) << "a header and both orders of three pairs";
    EXPECT_EQ(json::parse(contentsOf(file("r.json")))["pairs"].size(), 6u);
    expectRefusal(cullbench({"race", kSmall, "-s", "all"}), 2, "2 to 8");
}

TEST_F(CullbenchContract, worstIsACameraPathWhoseFirstViewLosesMost) {
    const ProcessResult result = cullbench({"worst", kSmall, "-s", "spherical", "--views", "20", "--size", "64x48", "--json",
                                            file("w.json"), "--svg", file("w.svg"), "--png", file("w.png")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("--eye "));
    const json worst = json::parse(contentsOf(file("w.json")));
    EXPECT_EQ(worst["views"].size(), 18u) << "all around in parts of 60 degrees; two more do not divide one";
    EXPECT_THAT(contentsOf(file("w.svg")), HasSubstr("azimuth"));
    const ProcessResult measured = cullbench({"measure", kSmall, "-s", "spherical", "--path", file("w.json"), "--size", "64x48",
                                              "--repeat", "1", "--no-limit", "--json", "-"});
    EXPECT_EQ(measured.exitStatus, 0) << measured.err;
    const json summary = json::parse(measured.out)["runs"][0]["summary"];
    for (const char* field : {"triangle_false_negative_rate", "triangle_false_positive_rate", "object_false_negative_rate",
                              "pixel_error_rate", "image_difference_mean", "silhouette_error_px_ci95", "views_with_loss_below"})
        EXPECT_TRUE(summary.contains(field)) << field;
    expectRefusal(cullbench({"worst", kSmall, "-s", "all,frustum"}), 2, "one strategy");
}

TEST_F(CullbenchContract, sweepPlotsAnyTwoFigures) {
    const ProcessResult result = cullbench({"sweep",    kSmall,
                                            "--path",   "fibonacci:2",
                                            "--size",   "64x48",
                                            "--repeat", "1",
                                            "-s",       "spherical",
                                            "--vary",   "rows=45,90",
                                            "--x",      "triangle_false_positive_rate",
                                            "--y",      "silhouette_error_px",
                                            "--svg",    file("p.svg"),
                                            "--csv",    file("p.csv")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(contentsOf(file("p.svg")), HasSubstr("silhouette error, pixels"));
    EXPECT_THAT(contentsOf(file("p.csv")), HasSubstr("popping_events_per_1000_frames"));
    expectRefusal(cullbench({"sweep", kSmall, "-s", "spherical", "--x", "beauty"}), 2, "pixel_error_rate");
}

}  // namespace
}  // namespace cullscope::test::cullbench_advice_test
