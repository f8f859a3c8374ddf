// The command line's contract (docs/command-line.md) for sweeps over parameters.

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_sweep_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// On a small scene: two views, one repetition.
ProcessResult sweep(const std::vector<std::string>& options) {
    std::vector<std::string> arguments{
        "sweep", "star:seed=7,triangles=500", "--path", "fibonacci:2", "--size", "64x48", "--repeat", "1"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return cullbench(arguments);
}

std::string contents(const std::string& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(CullbenchContract, sweepHasARowForEachValueAndForWhatIsNotVaried) {
    const ProcessResult result = sweep({"-s", "backface,spherical", "-p", "band=10", "--vary", "rows=45,90", "--json",
                                        file("s.json"), "--csv", file("s.csv"), "--svg", file("s.svg")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("spherical:band=10"));
    const json table = json::parse(contents(file("s.json")))["experiments"][0];
    EXPECT_EQ(table["experiment"], "sweep");
    EXPECT_EQ(table["scene"]["triangles"], 500);
    ASSERT_EQ(table["rows"].size(), 4u);
    EXPECT_EQ(table["rows"][0]["strategy"], "spherical:band=10");
    EXPECT_EQ(table["rows"][0]["parameter"], "rows");
    EXPECT_EQ(table["rows"][1]["value"], "90");
    EXPECT_GT(table["rows"][1]["ratio_to_all"], 0.0);
    EXPECT_GE(table["rows"][1]["missed_pixels"], 0.0);
    EXPECT_EQ(table["rows"][2]["strategy"], "backface");
    EXPECT_TRUE(table["rows"][2]["parameter"].is_null());
    EXPECT_EQ(table["rows"][3]["strategy"], "oracle") << "what any culling could gain at most stands in every table";
    const std::string csv = contents(file("s.csv"));
    EXPECT_TRUE(csv.starts_with("strategy,parameter,value,fps_overall,ratio_to_same_sides,ratio_to_same_sides_low,")) << csv;
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5) << "a header and four rows";
    EXPECT_THAT(contents(file("s.svg")),
                testing::AllOf(testing::StartsWith("<svg"), HasSubstr("spherical:band=10, rows"), HasSubstr("oracle")));
    EXPECT_THAT(sweep({"-s", "spherical", "--no-limit", "--json", "-"}).out, testing::Not(HasSubstr("\"oracle\"")));
}

TEST_F(CullbenchContract, everyStrategyThatHasTheParameterIsVaried) {
    const ProcessResult result = sweep({"-s", "all,frustum,frustum-octree", "--vary", "facing=front,two-sided", "--json", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    std::set<std::string> varied;
    const json rows = json::parse(result.out)["experiments"][0]["rows"];
    for (const json& row : rows)
        if (!row["parameter"].is_null()) varied.insert(row["strategy"]);
    EXPECT_THAT(varied, testing::IsSupersetOf({"frustum", "frustum-octree"}));
    EXPECT_THAT(result.err, HasSubstr("frustum-octree")) << "the table itself goes beside the data";
}

TEST_F(CullbenchContract, withoutVaryADeclaredSweepIsMeasured) {
    const ProcessResult result = sweep({"-s", "spherical", "--json", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("\"parameter\": \"rows\""));
}

TEST_F(CullbenchContract, sweepRefusesWhatItDoesNotKnow) {
    expectRefusal(sweep({}), 2, "strategy");
    expectRefusal(sweep({"-s", "nonsense"}), 2, "frustum");
    expectRefusal(sweep({"-s", "all"}), 2, "--vary");
    expectRefusal(sweep({"-s", "spherical", "--vary", "raws=1,2"}), 2, "raws");
    expectRefusal(sweep({"-s", "spherical,frustum", "--vary", "raws=1,2"}), 2, "none of the strategies");
    expectRefusal(sweep({"-s", "spherical", "--vary", "frustum.box=length"}), 2, "not among those of -s");
    expectRefusal(sweep({"-s", "spherical", "--vary", "rows=many"}), 2, "rows");
    expectRefusal(sweep({"-s", "spherical", "--vary", "rows="}), 2, "name values");
    expectRefusal(sweep({"-s", "spherical", "--vary", "rows"}), 2, "rows");
    expectRefusal(sweep({"-s", "spherical", "--csv", "-", "--svg", "-"}), 2, "--csv and --svg");
    expectRefusal(sweep({"-s", "spherical", "--csv", file("none/t.csv")}), 2, "t.csv");
    EXPECT_EQ(filesWritten(), 0u);
}

}  // namespace
}  // namespace cullscope::test::cullbench_sweep_test
