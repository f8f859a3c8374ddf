// The command line's contract (docs/command-line.md) for the store of results.

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <thread>

#include "core/base/error.h"
#include "core/experiments/store/result_store.h"
#include "core/geometry/random.h"
#include "tests/support/cullbench_contract.h"
#include "tests/support/long_mode.h"

namespace cullscope::test::cullbench_store_test {
namespace {

using nlohmann::json;
using store::ResultStore;
using testing::HasSubstr;

constexpr auto kExisting = store::Database::Access::Existing;

std::string contents(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<std::string> measuring(const std::string& file, const std::string& path, const std::string& strategies = "frustum") {
    return {
        CULLBENCH, "measure", "star:seed=7,triangles=500", "-s", strategies, "--path", path, "--size", "64x48", "--repeat", "2",
        "--store", file};
}

ProcessResult measureInto(const std::string& file, const std::vector<std::string>& more = {},
                          const std::string& path = "fibonacci:3", const std::string& strategies = "frustum,spherical") {
    std::vector<std::string> words = measuring(file, path, strategies);
    words.insert(words.end(), more.begin(), more.end());
    return runProcess(words);
}

/// Starts a program, whose words go nowhere.
pid_t started(const std::vector<std::string>& command) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stdout) == nullptr || freopen("/dev/null", "w", stderr) == nullptr) _exit(126);
        execv(words[0], words.data());
        _exit(127);
    }
    return child;
}

int endOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return status;
}

/// How many frames each measurement has, in the order of the list; every pose measured is there for every strategy.
std::vector<uint64_t> wholePoses(const std::string& file) {
    const ResultStore opened(file, kExisting);
    std::vector<uint64_t> poses;
    for (const store::Listed& listed : opened.list()) {
        const store::Stored stored = opened.read(listed.number);
        for (const store::StoredRun& run : stored.runs) {
            EXPECT_EQ(run.frames.size(), stored.listed.measured) << run.strategy << ": a pose without it in " << listed.number;
            for (size_t pose = 0; pose < run.run.frames.size(); ++pose) EXPECT_EQ(run.run.frames[pose].pose, pose);
        }
        poses.push_back(stored.listed.measured);
    }
    return poses;
}

TEST_F(CullbenchContract, storeGivesBackTheFilesThatMeasureWrote) {
    const std::string results = file("results");
    const ProcessResult result = measureInto(results, {"--json", file("a.json"), "--csv", file("a.csv")});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_EQ(cullbench({"store", results, "export", "1", "--json", file("b.json"), "--csv", file("b.csv")}).exitStatus, 0);
    EXPECT_EQ(contents(file("a.json")), contents(file("b.json")));
    EXPECT_EQ(contents(file("a.csv")), contents(file("b.csv")));
    const ProcessResult listed = cullbench({"store", results, "list", "--scene", "STAR", "-s", "spher", "--since", "2020"});
    EXPECT_THAT(listed.out, testing::AllOf(HasSubstr("frustum, spherical"), HasSubstr("whole"), HasSubstr("fibonacci:3")));
    EXPECT_THAT(cullbench({"store", results, "list", "--until", "2020"}).out, testing::Not(HasSubstr("spherical")));
    EXPECT_THAT(cullbench({"store", results, "show", "1"}).out, HasSubstr("cullbench measure star:seed=7,triangles=500"));
    expectRefusal(cullbench({"store", results, "show", "2"}), 2, "no measurement 2");
    expectRefusal(cullbench({"store", file("none"), "list"}), 3, "none");
    std::ofstream(file("other")) << "words";
    expectRefusal(cullbench({"store", file("other"), "list"}), 3, "no result store");
}

TEST_F(CullbenchContract, measurementsOfAStoreAreComparedWithIntervals) {
    const std::string results = file("results");
    ASSERT_EQ(measureInto(results).exitStatus, 0);
    ASSERT_EQ(measureInto(results).exitStatus, 0);
    ASSERT_EQ(measureInto(results, {}, "fibonacci:2").exitStatus, 0);
    const ProcessResult result = cullbench({"store", results, "compare", "1", "2"});
    ASSERT_EQ(result.exitStatus, 0) << result.err;
    EXPECT_THAT(result.out, testing::AllOf(HasSubstr("frustum"), HasSubstr("spherical"), HasSubstr("one after the other")));
    const ProcessResult within = cullbench({"store", results, "compare", "1:frustum", "1:spherical"});
    EXPECT_THAT(within.out, testing::AllOf(HasSubstr("times the speed of A"), testing::Not(HasSubstr("one after the other"))));
    EXPECT_THAT(cullbench({"store", results, "compare", "1:frustum", "1:frustum"}).out, HasSubstr("no difference"));
    expectRefusal(cullbench({"store", results, "compare", "1", "3"}), 2, "camera paths differ");
    ASSERT_EQ(measureInto(results, {"--windows", "4"}).exitStatus, 0);
    expectRefusal(cullbench({"store", results, "compare", "1", "4"}), 2, "numbers of windows differ");
    expectRefusal(cullbench({"store", results, "compare", "1:pvs", "2"}), 2, "no run of pvs");
    EXPECT_EQ(cullbench({"store", results, "compare", "1:all", "1:frustum"}).exitStatus, 0) << "baselines, too";
    expectRefusal(cullbench({"store", results, "compare", "one", "2"}), 2, "names no measurement");
}

/// What was committed before the signal is there after it, and each pose with all its strategies or not at all. Each round has a
/// store of its own, as reading all that was killed before would take longer than what is to be killed.
TEST_F(CullbenchContract, killedMeasurementKeepsEveryFinishedFrame) {
    Random random(11);
    size_t withFrames = 0;
    const uint64_t rounds = howMany(50, 4);
    for (uint64_t round = 0; round < rounds; ++round) {
        const std::string results = file("results-" + std::to_string(round));
        const double moment = random.between(0.1, 0.6);
        SCOPED_TRACE("killed after " + std::to_string(moment) + " seconds");
        const pid_t child = started(measuring(results, "fibonacci:50000"));
        std::this_thread::sleep_for(std::chrono::duration<double>(moment));
        const auto poses = [&] {
            const bool there = std::filesystem::exists(results) && std::filesystem::file_size(results) > 0;
            return there ? wholePoses(results) : std::vector<uint64_t>();
        };
        std::vector<uint64_t> before = poses();
        // On a busy machine it may not have begun: one measurement at least is killed with frames.
        for (int tries = 0; tries < 600 && round == 0 && before.empty(); ++tries) {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            before = poses();
        }
        kill(child, SIGKILL);
        EXPECT_TRUE(WIFSIGNALED(endOf(child))) << "it had ended by itself: nothing was tried";
        const std::vector<uint64_t> after = poses();
        ASSERT_GE(after.size(), before.size());
        if (!before.empty()) EXPECT_GE(after[0], before[0]);
        if (after.empty()) continue;
        ++withFrames;
        EXPECT_EQ(cullbench({"store", results, "export", "1", "--json", file("one.json")}).exitStatus, 0);
        EXPECT_EQ(json::parse(contents(file("one.json")))["runs"][0]["frames"].size(), after[0]);
        EXPECT_THAT(cullbench({"store", results, "list"}).out, HasSubstr("no end"));
    }
    EXPECT_GT(withFrames, 0u);
    RecordProperty("killed_with_frames", static_cast<int>(withFrames));
    std::cout << "long: " << rounds << " measurements killed, " << withFrames << " of them with frames\n";
}

TEST_F(CullbenchContract, twoProgramsWriteToOneStoreAtOnce) {
    const std::string results = file("results");
    const std::vector<pid_t> programs{started(measuring(results, "fibonacci:40")), started(measuring(results, "fibonacci:40")),
                                      started(measuring(results, "fibonacci:40"))};
    for (const pid_t program : programs) EXPECT_EQ(endOf(program), 0);
    EXPECT_EQ(wholePoses(results), std::vector<uint64_t>({40, 40, 40}));
}

TEST_F(CullbenchContract, fullDiskIsReportedAndLosesNothingStored) {
    const std::string results = file("results");
    ASSERT_EQ(measureInto(results, {"--json", file("a.json")}).exitStatus, 0);
    std::string line = "trap '' XFSZ; ulimit -f 200; exec";
    for (const std::string& word : measuring(results, "fibonacci:1000")) line += " '" + word + "'";
    const ProcessResult result = runProcess({"/bin/bash", "-c", line});
    EXPECT_EQ(result.exitStatus, 2);
    EXPECT_THAT(result.err, testing::AllOf(HasSubstr(results), HasSubstr("What was stored before is there")));
    EXPECT_THAT(result.out, HasSubstr("1000 of 1000 poses")) << "the table is printed all the same";
    const std::vector<uint64_t> poses = wholePoses(results);
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_EQ(poses[0], 3u);
    EXPECT_GT(poses[1], 0u);
    EXPECT_LT(poses[1], 1000u);
    EXPECT_EQ(cullbench({"store", results, "export", "1", "--json", file("b.json")}).exitStatus, 0);
    EXPECT_EQ(contents(file("a.json")), contents(file("b.json")));
    EXPECT_EQ(measureInto(results).exitStatus, 0) << "with room it is written again";
}

TEST_F(CullbenchContract, storeIsReadWhereNothingCanBeWrittenBesideIt) {
    const std::string results = file("results #1 50%.store");
    ASSERT_EQ(measureInto(results).exitStatus, 0);
    // No file may be larger than nothing: as on a full disk, in whose folder SQLite makes no index of its log.
    const std::string line = "(trap '' XFSZ; ulimit -f 0; exec '" CULLBENCH "' store '" + results + "' list 2>&1) | cat";
    const ProcessResult listed = runProcess({"/bin/bash", "-c", "set -o pipefail; " + line});
    EXPECT_EQ(listed.exitStatus, 0) << listed.out;
    EXPECT_THAT(listed.out, HasSubstr("fibonacci:3")) << listed.err;
    std::ofstream(file("empty")).flush();
    expectRefusal(cullbench({"store", file("empty"), "list"}), 3, "no result store");
    EXPECT_EQ(std::filesystem::file_size(file("empty")), 0u) << "reading made a store of it";
}

TEST_F(CullbenchContract, resultFilesAndCertificatesAreAddedToAStore) {
    ASSERT_EQ(measureInto(file("results"), {"--json", file("a.json")}).exitStatus, 0);
    ASSERT_EQ(cullbench({"certify", "frustum", "--views", "50", "--json", file("c.json")}).exitStatus, 0);
    const ProcessResult result = cullbench({"store", file("results"), "add", file("a.json"), file("c.json")});
    EXPECT_THAT(result.out, testing::AllOf(HasSubstr("measurement 2"), HasSubstr("certificate 1")));
    ASSERT_EQ(cullbench({"store", file("results"), "export", "2", "--json", file("b.json")}).exitStatus, 0);
    const json given = json::parse(contents(file("a.json")));
    const json back = json::parse(contents(file("b.json")));
    ASSERT_EQ(back["runs"].size(), given["runs"].size());
    for (size_t run = 0; run < given["runs"].size(); ++run) EXPECT_EQ(back["runs"][run]["frames"], given["runs"][run]["frames"]);
    EXPECT_EQ(back["scene"], given["scene"]);
    EXPECT_THAT(cullbench({"store", file("results"), "add", file("a.json"), file("c.json")}).out,
                testing::AllOf(HasSubstr("measurement 2"), HasSubstr("certificate 1"), HasSubstr("already")));
    // Another result that was written at the same moment is another measurement.
    ASSERT_EQ(measureInto(file("others"), {"--json", file("b.json")}, "fibonacci:3", "all,backface").exitStatus, 0);
    std::filesystem::last_write_time(file("b.json"), std::filesystem::last_write_time(file("a.json")));
    EXPECT_THAT(cullbench({"store", file("results"), "add", file("b.json")}).out,
                testing::AllOf(HasSubstr("measurement 3"), testing::Not(HasSubstr("already"))));
    std::ofstream(file("t.json")) << "{}";
    expectRefusal(cullbench({"store", file("results"), "add", file("t.json")}), 3, "no result file");
}

TEST_F(CullbenchContract, reportOfEveryKindGoesIntoAStore) {
    const std::string results = file("results"), drawn = file("drawn.json");
    std::ofstream(file("one.obj")) << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(drawn) << R"({"fovy_deg": 45, "near": 0.1, "far": 10,
        "poses": [{"eye": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "objects": []}]})";
    const std::vector<std::vector<std::string>> commands{
        {"advise", "sphere:triangles=200", "--path", "fibonacci:1", "--size", "64x48"},
        {"worst", "sphere:triangles=200", "-s", "spherical", "--views", "8", "--size", "64x48"},
        {"stability", "--case", "1"},
        {"judge", file("one.obj"), "--drawn", drawn, "--size", "64x48"},
        {"certify", "frustum", "--views", "50"}};
    const std::vector<std::string> kinds{store::kAdvice, store::kWorstView, store::kBattery, store::kJudgement,
                                         store::kCertificate};
    for (size_t i = 0; i < commands.size(); ++i) {
        std::vector<std::string> words = commands[i];
        words.insert(words.end(), {"--json", file("r.json"), "--store", results});
        const ProcessResult result = cullbench(words);
        ASSERT_LE(result.exitStatus, 1) << result.err;
        const store::StoredReport stored = ResultStore(results, kExisting).report(int64_t(i) + 1);
        EXPECT_EQ(stored.report.kind, kinds[i]);
        EXPECT_EQ(json::parse(stored.report.document), json::parse(contents(file("r.json"))));
        const ProcessResult shown = cullbench({"store", results, "report", std::to_string(i + 1), "--json", file("s.json")});
        EXPECT_THAT(shown.out, testing::AllOf(HasSubstr(kinds[i]), HasSubstr(" " + words.front() + " "), HasSubstr(result.out)));
        EXPECT_EQ(json::parse(contents(file("s.json"))), json::parse(contents(file("r.json"))));
    }
    EXPECT_THAT(cullbench({"store", results, "list", "-s", "spherical"}).out,
                testing::AllOf(HasSubstr(store::kWorstView), testing::Not(HasSubstr(store::kJudgement))));
    EXPECT_EQ(json::parse(cullbench({"store", results, "export", "--json", "-"}).out)["reports"].size(), kinds.size());
    expectRefusal(cullbench({"store", results, "report", "9"}), 2, "has no report 9");
    expectRefusal(cullbench({"worst", "sphere", "-s", "all", "--json", results, "--store", results}), 2, "is a result store");
    // Brought together with itself nothing is there twice; the same answer of another day is another one.
    EXPECT_THAT(cullbench({"store", results, "add", results}).out, HasSubstr("already"));
    ASSERT_EQ(cullbench({"stability", "--case", "1", "--store", results}).exitStatus, 0);
    EXPECT_EQ(ResultStore(results, kExisting).reports().size(), kinds.size() + 1);
}

TEST_F(CullbenchContract, resultFileNeverReplacesAStoreOrAnotherResultFile) {
    const std::string results = file("results");
    ASSERT_EQ(measureInto(results).exitStatus, 0);
    for (const char* option : {"--json", "--csv"}) {
        expectRefusal(measureInto(results, {option, results}), 2, "is a result store");
        expectRefusal(cullbench({"store", results, "export", option, results}), 2, "is a result store");
        expectRefusal(measureInto(file("new"), {option, file("new")}), 2, "is a result store");
    }
    for (const char* beside : {"-wal", "-shm"})
        expectRefusal(measureInto(file("new"), {"--csv", file(std::string("new") + beside)}), 2, "is a result store");
    expectRefusal(measureInto(file("new"), {"--json", file("a"), "--csv", file(".") + "/a"}), 2, "two result files");
    EXPECT_EQ(measureInto(file("other"), {"--json", "/dev/null", "--csv", "/dev/null"}).exitStatus, 0);
    EXPECT_EQ(ResultStore(results, kExisting).list().size(), 1u);
}

TEST_F(CullbenchContract, wrongWordsForAStoreAreNamed) {
    const std::string results = file("results");
    ASSERT_EQ(measureInto(results).exitStatus, 0);
    expectRefusal(cullbench({"store", file("nowhere"), "list"}), 3, "cannot be opened");
    EXPECT_FALSE(std::filesystem::exists(file("nowhere")));
    expectRefusal(cullbench({"store", results}), 2, "list, show, report, compare, export or add");
    expectRefusal(cullbench({"store", results, "frobnicate"}), 2, "\"frobnicate\"");
    expectRefusal(cullbench({"store", results, "show", "-1"}), 2, "no number of a measurement");
    expectRefusal(cullbench({"store", results, "show", "x"}), 2, "no number of a measurement");
    expectRefusal(cullbench({"store", results, "list", "--since", "yesterday"}), 2, "no date");
    expectRefusal(cullbench({"store", results, "list", "--since", "2026-13"}), 2, "no date");
    expectRefusal(cullbench({"store", results, "list", "--until", "2026-02-31"}), 2, "no date");
    EXPECT_EQ(cullbench({"store", results, "list", "--since", "2026-11", "--until", "2999"}).exitStatus, 0);
}

/// Written by the first layout, as it was kept.
constexpr const char* kFirstLayout = R"(
CREATE TABLE measurement (number INTEGER PRIMARY KEY AUTOINCREMENT, started TEXT NOT NULL, ended TEXT,
    interrupted INTEGER NOT NULL, experiment TEXT NOT NULL, command TEXT NOT NULL, tool_name TEXT NOT NULL,
    tool_version TEXT NOT NULL, tool_commit TEXT NOT NULL, cpu TEXT NOT NULL, gl_renderer TEXT NOT NULL,
    gl_version TEXT NOT NULL, gl_software INTEGER NOT NULL, scene TEXT NOT NULL, scene_sha256 TEXT NOT NULL,
    triangles INTEGER NOT NULL, instances INTEGER NOT NULL, path TEXT NOT NULL, poses INTEGER NOT NULL,
    width INTEGER NOT NULL, height INTEGER NOT NULL);
CREATE TABLE run (number INTEGER PRIMARY KEY AUTOINCREMENT, measurement INTEGER NOT NULL, place INTEGER NOT NULL,
    strategy TEXT NOT NULL, asked_for INTEGER NOT NULL, is_limit INTEGER NOT NULL, head TEXT NOT NULL,
    UNIQUE (measurement, place));
CREATE TABLE frame (run INTEGER NOT NULL, pose INTEGER NOT NULL, own_raster INTEGER NOT NULL, fields TEXT NOT NULL,
    frame_times TEXT NOT NULL, cull_times TEXT NOT NULL, PRIMARY KEY (run, pose)) WITHOUT ROWID;
INSERT INTO measurement VALUES (1, '2026-11-25T16:00:00.000Z', '2026-11-25T16:00:01.000Z', 0, 'measure', 'cullbench measure',
    'cullscope', '0.1.0', 'abc', 'cpu', 'llvmpipe', '4.5', 1, 'kept', '00', 12, 1, 'fibonacci:1', 1, 64, 48);
INSERT INTO run VALUES (1, 1, 1, 'all', 1, 0, '{"strategy":"all","promise":"conservative","facing":"two-sided",
    "reference_facing":"two-sided","same_sides_baseline":"all","parameters":{},"build_ms":1.5,"structure_bytes":9}');
INSERT INTO frame VALUES (1, 0, 0, '{"pose":0,"frame_ms":2.0,"cull_ms":0.0,"repetitions":2,"considered_triangles":12,
    "submitted_triangles":12,"covered_pixels":null}', '[2.0,2.0]', '[0.0,0.0]');
PRAGMA application_id = 1131768940; PRAGMA user_version = 1;
)";

constexpr const char* kSecondAndThirdLayout = R"(
ALTER TABLE run ADD COLUMN figures TEXT;
CREATE INDEX measurement_by_time ON measurement (started);
CREATE TABLE certificate (number INTEGER PRIMARY KEY AUTOINCREMENT, added TEXT NOT NULL, strategy TEXT NOT NULL,
    document TEXT NOT NULL);
ALTER TABLE frame ADD COLUMN judged TEXT;
INSERT INTO certificate VALUES (7, '2026-11-25T17:00:00.000Z', 'frustum', '{"views":50}');
PRAGMA user_version = 3;
)";

TEST_F(CullbenchContract, olderStoreIsMigratedAndNewerOneRefused) {
    const std::string results = file("results");
    store::Database(results, store::Database::Access::Write).run(kFirstLayout);
    EXPECT_THAT(cullbench({"store", results, "show", "1"}).out, testing::AllOf(HasSubstr("kept"), HasSubstr("500.00")));
    EXPECT_EQ(measureInto(results).exitStatus, 0) << "it is written to as a new one";
    EXPECT_EQ(wholePoses(results), std::vector<uint64_t>({1, 3}));
    const std::string third = file("third");
    store::Database(third, store::Database::Access::Write).run((std::string(kFirstLayout) + kSecondAndThirdLayout).c_str());
    EXPECT_THAT(cullbench({"store", third, "list"}).out, HasSubstr("kept"));
    const ResultStore opened(third, kExisting);
    ASSERT_EQ(opened.reports().size(), 1u) << "certificates are reports now";
    EXPECT_EQ(opened.report(7).report.strategy, "frustum");
    EXPECT_THAT(cullbench({"store", third, "report", "7"}).out, testing::AllOf(HasSubstr("certificate"), HasSubstr("2026")));
    store::Database(results, store::Database::Access::Write).run("PRAGMA user_version = 99");
    expectRefusal(cullbench({"store", results, "list"}), 3, "newer version");
    expectRefusal(measureInto(results), 3, "newer version");
    store::Database(results, store::Database::Access::Write).run("PRAGMA user_version = 4; PRAGMA application_id = 7");
    expectRefusal(cullbench({"store", results, "list"}), 3, "no result store");
}

}  // namespace
}  // namespace cullscope::test::cullbench_store_test
