// The output of cullbench about the causes for which strategies cull triangles, and about their structures.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/process.h"

namespace causes_test {
namespace {

using cullscope::test::ProcessResult;
using cullscope::test::runProcess;
using nlohmann::json;
using testing::HasSubstr;

ProcessResult cullbench(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), CULLBENCH);
    return runProcess(arguments);
}

TEST(CullbenchCauses, causesAddUpToTheScene) {
    const ProcessResult result = cullbench({"measure", "star:seed=3,triangles=20000", "-s", "frustum,spherical-lossless",
                                            "--path", "case-2", "--size", "64x48", "--repeat", "1", "--json", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    const json root = json::parse(result.out);
    const json &frustum = root["runs"][0]["frames"], &lossless = root["runs"][1]["frames"];
    uint64_t outside = 0, backFacing = 0, noSample = 0;
    for (size_t i = 0; i < lossless.size(); ++i) {
        for (const json& frame : {frustum[i], lossless[i]}) {
            uint64_t sum = frame["considered_triangles"];
            for (const char* field :
                 {"culled_outside_frustum", "culled_back_facing", "culled_hidden", "culled_too_small", "culled_no_sample"})
                sum += frame[field].get<uint64_t>();
            EXPECT_EQ(sum, root["scene"]["triangles"].get<uint64_t>());
        }
        EXPECT_EQ(frustum[i]["culled_back_facing"], 0);
        outside += lossless[i]["culled_outside_frustum"].get<uint64_t>();
        backFacing += lossless[i]["culled_back_facing"].get<uint64_t>();
        noSample += lossless[i]["culled_no_sample"].get<uint64_t>();
    }
    EXPECT_GT(outside, 0u);
    EXPECT_GT(backFacing, 0u);
    EXPECT_GT(noSample, 0u);
    EXPECT_THAT(result.err,
                testing::ContainsRegex("spherical-lossless culled by cause: outside the frustum [0-9.]+ %, back-facing"));
    EXPECT_THAT(result.err, testing::Not(HasSubstr("frustum culled by cause"))) << "the table says all";
}

TEST(CullbenchCauses, inspectTellsOfLayoutAndKernels) {
    const ProcessResult words = cullbench({"inspect", "knot:triangles=4000", "-s", "spherical-lossless"});
    EXPECT_THAT(words.out, HasSubstr("layout octahedral"));
    EXPECT_THAT(words.out, HasSubstr("inner kernel of 1 mesh: the centre of the bounding sphere lies outside the solid"));
    const json root = json::parse(cullbench({"inspect", "field:mesh=star:triangles=4000,n=3", "-s", "spherical-lossless", "-p",
                                             "layout=latitude-longitude", "--json", "-"})
                                      .out);
    EXPECT_EQ(root["layout"], "latitude-longitude");
    EXPECT_EQ(root["kernels"], json::parse(R"([{"state": "filled", "meshes": 1}])")) << "nine objects, one mesh";
    const ProcessResult other = cullbench({"inspect", "sphere:triangles=200", "-s", "spherical"});
    EXPECT_EQ(other.exitStatus, 0);
    EXPECT_THAT(other.out, testing::Not(HasSubstr("layout")));
    EXPECT_EQ(cullbench({"inspect", "sphere:triangles=200", "-s", "spherical-lossless", "--hide", "0"}).exitStatus, 0);
}

TEST(CullbenchCauses, parameterAfterACommaBelongsToItsStrategy) {
    const ProcessResult result =
        cullbench({"measure", "sphere:triangles=2000", "-s", "spherical-lossless:facing=front,level=4,backface", "--size",
                   "32x32", "--repeat", "1", "--json", "-"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    const json runs = json::parse(result.out)["runs"];
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0]["parameters"]["level"], 4);
    EXPECT_EQ(runs[0]["parameters"]["facing"], "front");
    EXPECT_EQ(runs[1]["strategy"], "backface");
    const ProcessResult alone = cullbench({"measure", "sphere:triangles=2000", "-s", "level=4"});
    EXPECT_EQ(alone.exitStatus, 2);
}

TEST(CullbenchCauses, onlyPartsThatHoldAreSaidToBeUsed) {
    const auto measured = [](const char* facing) {
        const ProcessResult result = cullbench({"measure", "sphere:triangles=8000", "-s", facing, "--path", "orbit:3", "--size",
                                                "32x32", "--repeat", "1", "--json", "-"});
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        return result;
    };
    const ProcessResult both = measured("spherical-lossless:facing=two-sided"),
                        front = measured("spherical-lossless:facing=front");
    EXPECT_THAT(both.err,
                HasSubstr("used cells against the frustum in 3 of 3 poses, normal cones in none, horizon of the kernel in none"));
    EXPECT_THAT(front.err, HasSubstr("normal cones in 3, horizon of the kernel in none")) << "few triangles, all in view";
    const json parts = json::parse(front.out)["runs"][0]["frames"][0]["parts"];
    EXPECT_EQ(parts["normal cones"]["objects"], 1);
    EXPECT_EQ(parts["horizon of the kernel"]["objects"], 0);
}

}  // namespace
}  // namespace causes_test
