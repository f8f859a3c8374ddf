// The command line's contract (docs/command-line.md) for studies: many commands into one store, on one machine or on a cluster.
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/experiments/store/result_store.h"
#include "tests/support/cullbench_contract.h"

namespace cullscope::test::cullbench_study_test {
namespace {

using nlohmann::json;
using store::ResultStore;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr auto kExisting = store::Database::Access::Existing;

json jsonOf(const std::string& path) {
    std::ifstream in(path);
    return json::parse(in);
}

/// A folder with a program in place of sbatch, which runs the tasks of an array at once, one after the other, and kills one of
/// them before it runs again, as a node's end would.
class Study : public CullbenchContract {
protected:
    void SetUp() override {
        CullbenchContract::SetUp();
        std::filesystem::create_directories(file("bin"));
        std::ofstream(file("bin/sbatch")) << kSbatch;
        std::filesystem::permissions(file("bin/sbatch"), std::filesystem::perms::owner_all);
        std::ofstream(file("study.txt")) << kLines;
    }
    [[nodiscard]] ProcessResult slurm(std::vector<std::string> words) const {
        words.insert(words.begin(), CULLSCOPE_SOURCE_DIR "/packaging/slurm");
        return runProcess(words, {"PATH=" + file("bin") + ":" + std::getenv("PATH")});
    }

private:
    static constexpr const char* kSbatch = R"(#!/bin/bash
tasks=1
for option in "$@"; do
    case $option in
        --array=1-*) tasks=${option#--array=1-} ;;
        --wrap=*) wrapped=${option#--wrap=} ;;
        --dependency=afterany:17) ;;
        --dependency=*) exit 9 ;;
    esac
done
for ((task = 1; task <= tasks; ++task)); do
    if ((task == 2)); then
        SLURM_ARRAY_TASK_ID=$task setsid sh -c "$wrapped" > /dev/null 2>&1 &
        sleep 0.7
        kill -KILL -- "-$!" 2> /dev/null
        wait "$!" 2> /dev/null
    fi
    SLURM_ARRAY_TASK_ID=$task sh -c "$wrapped" > /dev/null || exit 8
done
echo 17
)";
    static constexpr const char* kLines = R"(# Three scenes, a certificate and a case of the battery.
measure teapot:triangles=500 -s all,frustum --path fibonacci:2 --size 64x48 --repeat 1

sweep 'star:seed=7,triangles=500' -s spherical --vary rows=45,90 --path fibonacci:2 --size 64x48 --repeat 1
cullbench race torus:triangles=500 -s all,backface --path fibonacci:2 --size 64x48 --repeat 1
certify frustum --views 50
stability --case 1
)";
};

TEST_F(Study, partsAreBroughtTogetherInOneStore) {
    for (const char* shard : {"1/2", "2/2"}) {
        const ProcessResult part =
            cullbench({"study", file("study.txt"), "--store", file(std::string("part-") + shard[0]), "--shard", shard});
        EXPECT_EQ(part.exitStatus, 0) << part.err;
    }
    const ProcessResult added = cullbench({"store", file("all"), "add", file("part-1"), file("part-2")});
    EXPECT_EQ(added.exitStatus, 0) << added.err;
    EXPECT_THAT(added.out,
                AllOf(HasSubstr("measurement 3"), HasSubstr("battery 1"), HasSubstr("certificate 2"), Not(HasSubstr("already"))));
    const ResultStore all(file("all"), kExisting);
    std::vector<std::string> experiments;
    for (const store::Listed& one : all.list()) experiments.push_back(one.origin.experiment);
    EXPECT_THAT(experiments, testing::UnorderedElementsAre("measure", "race", "sweep"));
    const store::Stored copy = all.read(1), given = ResultStore(file("part-1"), kExisting).read(1);
    ASSERT_EQ(copy.runs.size(), given.runs.size());
    for (size_t run = 0; run < copy.runs.size(); ++run) {
        EXPECT_EQ(copy.runs[run].frames, given.runs[run].frames);
        EXPECT_EQ(copy.runs[run].run.frames.front().frameTimes, given.runs[run].run.frames.front().frameTimes);
    }
    // What is there is not added twice, nor is it measured twice.
    EXPECT_THAT(cullbench({"store", file("all"), "add", file("part-1"), file("all")}).out, HasSubstr("already"));
    const ProcessResult again = cullbench({"study", file("study.txt"), "--store", file("part-1"), "--shard", "1/2"});
    EXPECT_THAT(again.err, AllOf(HasSubstr("line 2 is done"), HasSubstr("line 5 is done"), HasSubstr("line 7 is done")));
    const ProcessResult merged = cullbench({"study", file("study.txt"), "--store", file("all")});
    EXPECT_THAT(merged.err, AllOf(HasSubstr("line 2 is done"), HasSubstr("line 4 is done"), HasSubstr("line 5 is done"),
                                  HasSubstr("line 7 is done")))
        << "though to another store";
    EXPECT_EQ(all.list().size(), 3u);
    EXPECT_EQ(all.reports().size(), 2u);
}

TEST_F(Study, unfinishedLineIsMeasuredAnewAndTheOthersAreNot) {
    std::ofstream(file("long.txt")) << "measure teapot:triangles=500 -s all --path fibonacci:2000 --size 320x240 --repeat 3\n";
    EXPECT_EQ(cullbench({"study", file("long.txt"), "--store", file("s")}, {}, 1.5).exitStatus, 130);
    ASSERT_EQ(ResultStore(file("s"), kExisting).list().size(), 1u);
    EXPECT_EQ(cullbench({"study", file("long.txt"), "--store", file("s")}, {}, 1.5).exitStatus, 130);
    EXPECT_EQ(ResultStore(file("s"), kExisting).list().size(), 1u) << "in the place of the unfinished one";
}

TEST_F(Study, wrongLinesAreNamedBeforeAnythingIsMeasured) {
    const auto refused = [&](const std::string& line, int status, const std::string& mentions) {
        std::ofstream(file("wrong.txt")) << "measure teapot:triangles=500 -s all\n" << line << "\n";
        expectRefusal(cullbench({"study", file("wrong.txt"), "--store", file("none")}), status, mentions);
        EXPECT_THAT(cullbench({"study", file("wrong.txt"), "--store", file("none")}).err, HasSubstr("wrong.txt, line 2"));
        EXPECT_FALSE(std::filesystem::exists(file("none")));
    };
    refused("render teapot -s all", 3, "does not begin with one of the commands");
    refused("measure teapot -s 'all", 3, "Close its quotes");
    refused("measure teapot -s all > table.txt", 3, "outside of quotes");
    refused("measure teapot -s all --store other", 3, "leave out --store");
    refused("measure $CULLSCOPE_NO_SUCH_VARIABLE", 3, "not set");
    expectRefusal(cullbench({"study", file("no.txt"), "--store", file("none")}), 3, "cannot be opened");
    expectRefusal(cullbench({"study", file("study.txt"), "--store", file("none"), "--shard", "3/2"}), 2, "3/2");
}

TEST_F(Study, lineThatFailsIsNamedAndTheOthersAreMeasured) {
    std::ofstream(file("some.txt")) << "measure nosuch.obj -s all\n"
                                    << "measure teapot:triangles=500 -s all --path fibonacci:1 --size 64x48 --repeat 1\n";
    const ProcessResult result = cullbench({"study", file("some.txt"), "--store", file("s")});
    EXPECT_EQ(result.exitStatus, 3);
    EXPECT_THAT(result.err, AllOf(HasSubstr("nosuch.obj cannot be opened"), HasSubstr("exit status: 1 (3)")));
    EXPECT_EQ(ResultStore(file("s"), kExisting).list().size(), 1u);
}

TEST_F(Study, certificateOfASlurmArrayIsMerged) {
    for (int time = 0; time < 2; ++time) {
        const ProcessResult result = slurm({CULLBENCH, file("study"), "frustum", "600", "3", "--partition=any"});
        EXPECT_EQ(result.exitStatus, 0) << result.err;
        EXPECT_THAT(result.out, HasSubstr("merged.json"));
    }
    const json merged = jsonOf(file("study/merged.json"));
    EXPECT_TRUE(merged["complete"]);
    EXPECT_EQ(merged["views"], 600);
    EXPECT_EQ(merged["lost_views"], 0);
    EXPECT_EQ(ResultStore(file("study/results.store"), kExisting).reports().size(), 1u) << "submitted twice";
    EXPECT_EQ(slurm({CULLBENCH, file("study"), "frustum", "many", "3"}).exitStatus, 2);
    EXPECT_EQ(slurm({CULLBENCH, file("study"), "nosuch", "600", "3"}).exitStatus, 2);
    EXPECT_EQ(slurm({}).exitStatus, 2);
}

TEST_F(Study, linesOfASlurmArrayComeIntoOneStore) {
    const ProcessResult result = slurm({CULLBENCH, file("results of it"), "study", file("study.txt"), "3"});
    EXPECT_EQ(result.exitStatus, 0) << result.err;
    const ResultStore all(file("results of it/results.store"), kExisting);
    EXPECT_EQ(all.reports().size(), 2u);
    ASSERT_EQ(all.list().size(), 3u);
    for (const store::Listed& one : all.list()) EXPECT_FALSE(one.interrupted) << one.origin.command;
    EXPECT_EQ(slurm({CULLBENCH, file("results of it"), "study", file("nosuch.txt"), "3"}).exitStatus, 2);
}

}  // namespace
}  // namespace cullscope::test::cullbench_study_test
