// The command line's contract (docs/command-line.md) for the battery, the suite, judge and certify.

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_battery_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

json jsonOf(const std::string& path) {
    std::ifstream in(path);
    return json::parse(in);
}

TEST_F(CullbenchContract, stabilityHasALineForEachCase) {
    const ProcessResult result = cullbench({"stability", "--case", "27", "--json", file("battery.json")});
    EXPECT_EQ(result.exitStatus, 0) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("27-cycle"));
    EXPECT_THAT(result.out, HasSubstr("painter sort=centroid"));
    EXPECT_THAT(result.out, HasSubstr("1 of 1 cases right"));
    const json battery = jsonOf(file("battery.json"));
    EXPECT_EQ(battery["cases"][0]["id"], "27-cycle");
    EXPECT_TRUE(battery["cases"][0]["right"]);
    EXPECT_GT(battery["cases"][0]["findings"].size(), 60u);
    const ProcessResult two = cullbench({"stability", "--case", "20-tiny"});
    EXPECT_EQ(two.exitStatus, 0) << two.out;
    expectRefusal(cullbench({"stability", "--case", "99"}), 2, "16-bowl");
}

TEST_F(CullbenchContract, galleryIsRenderedAndMeasuredFromItsOwnCameras) {
    EXPECT_EQ(cullbench({"render", "gallery/case-27-cycle", "-s", "painter", "--size", "64x48", "-o", file("a.png")}).exitStatus,
              0);
    const ProcessResult measured =
        cullbench({"measure", "gallery/case-11-centre", "-s", "all", "--size", "64x48", "--repeat", "1"});
    EXPECT_EQ(measured.exitStatus, 0) << measured.err;
    EXPECT_THAT(measured.out, HasSubstr("3 of 3 poses of given"));
    // A lens of a hundredth of a degree: with another one the body would be a pixel.
    const ProcessResult narrow = cullbench(
        {"measure", "gallery/case-23-narrow", "-s", "all", "--size", "64x48", "--repeat", "1", "--json", file("n.json")});
    EXPECT_EQ(narrow.exitStatus, 0) << narrow.err;
    EXPECT_GT(jsonOf(file("n.json"))["runs"][0]["frames"][0]["covered_pixels"], 1000);
    EXPECT_THAT(cullbench({"list", "scenes"}).out, HasSubstr("gallery/case-16-bowl"));
    expectRefusal(cullbench({"measure", "gallery/case-99", "-s", "all"}), 3, "case-99");
}

TEST_F(CullbenchContract, suiteIsJudgedRightAndWhatIsMissingIsFound) {
    ASSERT_EQ(cullbench({"suite", file("suite")}).exitStatus, 0);
    const std::string scene = file("suite/field.obj"), required = file("suite/field.required.json");
    const std::vector<std::string> judge{"judge", scene, "--path", required, "--size", "320x240", "--drawn"};
    const auto judged = [&](const std::string& drawn, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments = judge;
        arguments.push_back(drawn);
        arguments.insert(arguments.end(), more.begin(), more.end());
        return cullbench(arguments);
    };
    const ProcessResult right = judged(required, {"--json", file("right.json")});
    EXPECT_EQ(right.exitStatus, 0) << right.out << right.err;
    EXPECT_EQ(jsonOf(file("right.json"))["summary"]["missed_pixels"], 0);
    // The size that the file has is that of the judgement, where no other one is asked for.
    const ProcessResult atItsSize = cullbench({"judge", scene, "--drawn", required, "--json", file("size.json")});
    EXPECT_EQ(atItsSize.exitStatus, 0) << atItsSize.out;
    EXPECT_EQ(jsonOf(file("size.json"))["summary"], jsonOf(file("right.json"))["summary"]);
    json large = jsonOf(required);
    large["size"] = {320, 0};
    std::ofstream(file("large.json")) << large;
    expectRefusal(cullbench({"judge", scene, "--drawn", file("large.json")}), 3, "two whole numbers");
    // An object less at one pose.
    json less = jsonOf(required);
    for (json& pose : less["poses"]) pose.erase("triangles");
    const json missing = less["poses"][3]["objects"].back();
    less["poses"][3]["objects"].erase(less["poses"][3]["objects"].size() - 1);
    std::ofstream(file("less.json")) << less;
    const ProcessResult wrong = judged(file("less.json"), {"--json", file("wrong.json")});
    EXPECT_EQ(wrong.exitStatus, 1);
    EXPECT_THAT(wrong.out, HasSubstr("Something that is seen is missing"));
    const json poses = jsonOf(file("wrong.json"))["poses"];
    ASSERT_EQ(poses[3]["missing_objects"].size(), 1u);
    EXPECT_EQ(poses[3]["missing_objects"][0]["number"], missing);
    EXPECT_EQ(poses[2]["missing_objects"].size(), 0u);
    // Who hands out the cameras says the size: a program's file cannot make the pictures too small to see what it leaves out.
    less["size"] = {1, 1};
    std::ofstream(file("small.json")) << less;
    const ProcessResult handedOut =
        cullbench({"judge", scene, "--drawn", file("small.json"), "--path", required, "--json", file("handed.json")});
    EXPECT_EQ(handedOut.exitStatus, 1) << handedOut.out;
    EXPECT_EQ(jsonOf(file("handed.json"))["summary"], jsonOf(file("wrong.json"))["summary"]);
    EXPECT_EQ(jsonOf(file("handed.json"))["size"], json({320, 240}));
    EXPECT_EQ(jsonOf(file("handed.json"))["drawn"], file("small.json"));
    // Where nothing is seen, nothing is judged.
    json away = json{{"poses", json::array()}};
    away["poses"].push_back({{"eye", {0, 0, 1e6}}, {"target", {0, 0, 2e6}}, {"up", {0, 1, 0}}, {"objects", json::array()}});
    std::ofstream(file("away.json")) << away;
    const ProcessResult unseen = cullbench({"judge", scene, "--drawn", file("away.json"), "--size", "64x48"});
    EXPECT_EQ(unseen.exitStatus, 1);
    EXPECT_THAT(unseen.out, HasSubstr("cannot be judged"));
    // The same as a strategy, in which the other program's loss is a strategy's.
    const ProcessResult recorded = cullbench({"measure", scene, "-s", "recorded", "-p", "file=" + file("less.json"), "--path",
                                              required, "--size", "320x240", "--repeat", "1", "--json", file("recorded.json")});
    EXPECT_EQ(recorded.exitStatus, 0) << recorded.err;
    const json frames = jsonOf(file("recorded.json"))["runs"][0]["frames"];
    for (size_t pose = 0; pose < frames.size(); ++pose)
        EXPECT_EQ(frames[pose]["missed_pixels"], poses[pose]["missed_pixels"]) << pose;
    EXPECT_GT(frames[3]["missed_pixels"], 0);
    expectRefusal(cullbench({"measure", scene, "-s", "recorded", "-p", "file=" + file("none.json")}), 3, "none.json");
    expectRefusal(cullbench({"measure", scene, "-s", "recorded", "-p", "file="}), 2, "key=value");
    expectRefusal(judged(file("none.json")), 3, "none.json");
    expectRefusal(cullbench({"judge", scene, "--drawn", required, "--facing", "back"}), 2, "--facing");
}

TEST_F(CullbenchContract, certifiedShardsAreMergedAndGoOn) {
    const ProcessResult whole =
        cullbench({"certify", "frustum-octree", "--views", "200", "--json", file("whole.json"), "--threads", "2"});
    EXPECT_EQ(whole.exitStatus, 0) << whole.err;
    EXPECT_THAT(whole.out, HasSubstr("200 views within its promise"));
    EXPECT_THAT(whole.out, HasSubstr("0 lost a pixel (rate below 3/200"));
    for (const char* shard : {"1/2", "2/2"})
        EXPECT_EQ(cullbench({"certify", "frustum-octree", "--views", "200", "--shard", shard, "--state",
                             file(std::string("shard-") + shard[0] + ".json")})
                      .exitStatus,
                  0);
    const ProcessResult merged =
        cullbench({"certify", "--merge", file("shard-1.json"), file("shard-2.json"), "--json", file("merged.json")});
    EXPECT_EQ(merged.exitStatus, 0) << merged.err;
    EXPECT_EQ(jsonOf(file("merged.json"))["covered_pixels"], jsonOf(file("whole.json"))["covered_pixels"]);
    EXPECT_TRUE(jsonOf(file("merged.json"))["complete"]);
    expectRefusal(cullbench({"certify"}), 2, "Name the strategy");
    expectRefusal(cullbench({"certify", "frustum", "--shard", "3/2"}), 2, "--shard 3/2");
    expectRefusal(cullbench({"certify", "frustum", "--merge", file("shard-1.json")}), 2, "--merge");
    expectRefusal(cullbench({"certify", "frustum", "--state", file("shard-1.json")}), 2, "another run");
    EXPECT_THAT(cullbench({"certify", "recorded", "--views", "50"}).out, HasSubstr("0 views within its promise"))
        << "it decides nothing without its file";
    const ProcessResult nothing = cullbench({"certify", "level-of-detail", "--views", "50"});
    EXPECT_EQ(nothing.exitStatus, 0);
    EXPECT_THAT(nothing.out, HasSubstr("nothing to certify"));
}

TEST_F(CullbenchContract, certifyingProcessesFindWhatOneFinds) {
    const std::vector<std::string> words{"certify", "frustum,painter", "--views", "200", "--json"};
    const auto result = [&](const std::string& threads) {
        std::vector<std::string> all = words;
        all.insert(all.end(), {file(threads + ".json"), "--threads", threads});
        const ProcessResult ended = cullbench(all);
        EXPECT_EQ(ended.exitStatus, 0) << ended.err;
        return jsonOf(file(threads + ".json"));
    };
    const json one = result("1");
    EXPECT_EQ(one.size(), 2u) << "a certificate for each strategy";
    EXPECT_EQ(one, result("3"));
    const ProcessResult stored = cullbench({"store", file("s.store"), "add", file("1.json")});
    EXPECT_EQ(stored.exitStatus, 0) << stored.err;
    EXPECT_THAT(cullbench({"store", file("s.store"), "list"}).out, testing::AllOf(HasSubstr("frustum"), HasSubstr("painter")));
}

TEST_F(CullbenchContract, certifyingIsStoppedWithItsProcessesAndGoesOn) {
    const std::vector<std::string> words{CULLBENCH, "certify",          "frustum",   "--views", "100000000",
                                         "--state", file("state.json"), "--threads", "2"};
    const ProcessResult stopped = runProcess(words, {}, 2.0);
    EXPECT_EQ(stopped.exitStatus, 130) << stopped.err;
    EXPECT_EQ(stopped.err, "") << "the processes say nothing of their own end";
    EXPECT_GT(jsonOf(file("state.json"))["views"], 0);
}

TEST_F(CullbenchContract, certifyingSaysWhereOneOfItsProcessesEnded) {
    // Two processes: the shell's child is the command, whose children try the blocks.
    const ProcessResult result =
        runProcess({"/bin/sh", "-c",
                    "\"$0\" certify frustum --views 100000000 --threads 2 & command=$!; "
                    "tries=0; until children=$(cat /proc/$command/task/*/children 2> /dev/null) && test $(echo "
                    "$children | wc -w) = 2; do sleep 0.1; tries=$((tries+1)); test $tries -lt 300 || exit 9; done; "
                    "kill -9 ${children%% *}; wait $command",
                    CULLBENCH});
    EXPECT_EQ(result.exitStatus, 4) << result.out << result.err;
    EXPECT_THAT(result.err, HasSubstr("ended by itself"));
}

}  // namespace
}  // namespace cullscope::test::cullbench_battery_test
