// Standard streams and interrupts: what cullbench does where the reader has gone, nothing can be written, or it is stopped early.

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/terminal_text.h"
#include "tests/support/cullbench_contract.h"

namespace cullbench_streams_test {
namespace {

using cullscope::test::cullbench;
using cullscope::test::CullbenchContract;
using cullscope::test::expectRefusal;
using cullscope::test::ProcessResult;
using cullscope::test::runProcess;
using testing::HasSubstr;
using testing::Not;

const std::string kMeasure = "'" CULLBENCH "' measure sphere:triangles=80 -s all --path fibonacci:2 --size 16x16 --repeat 1";

class CullbenchStreams : public CullbenchContract {
protected:
    /// Runs a line of the shell; the exit status of its first program stands in the output.
    static ProcessResult shell(const std::string& line) { return runProcess({"/bin/sh", "-c", line}); }
    [[nodiscard]] std::string contents(const std::string& name) const {
        std::ifstream in(file(name));
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] bool isWholeJson(const std::string& name) const { return nlohmann::json::accept(contents(name)); }
};

TEST_F(CullbenchStreams, readerThatEndsCostsNoFile) {
    // `true` reads nothing and ends at once.
    const std::string json = file("a.json");
    const ProcessResult measured = shell("( " + kMeasure + " --json " + json + "; echo status $? >&2 ) | true");
    EXPECT_EQ(measured.err, "status 0\n");
    EXPECT_TRUE(isWholeJson("a.json"));
    const std::string swept = file("b.json");
    const std::string sweep = "'" CULLBENCH
                              "' sweep sphere:triangles=80 -s spherical --vary rows=45 --path orbit:1 --size 16x16 "
                              "--repeat 1 --json " +
                              swept;
    EXPECT_EQ(shell("( " + sweep + "; echo status $? >&2 ) | true").err, "status 0\n");
    EXPECT_TRUE(isWholeJson("b.json"));
    const std::string reproduced = file("c.json");
    EXPECT_EQ(shell("( '" CULLBENCH "' reproduce quiz --json " + reproduced + "; echo status $? >&2 ) | true").err, "status 0\n");
    EXPECT_TRUE(isWholeJson("c.json"));
}

TEST_F(CullbenchStreams, readerThatEndsIsNoErrorWhereWordsAreReadAndOneWhereDataAre) {
    EXPECT_EQ(shell("( '" CULLBENCH "' list; echo status $? >&2 ) | true").err, "status 0\n");
    EXPECT_EQ(shell("( '" CULLBENCH "' --help; echo status $? >&2 ) | true").err, "status 0\n");
    const std::string data = shell("( '" CULLBENCH "' path orbit:3 sphere:triangles=20 -o -; echo status $? >&2 ) | true").err;
    EXPECT_THAT(data, HasSubstr("status 2\n"));
    EXPECT_THAT(data, HasSubstr("the program that reads it has ended"));
}

TEST_F(CullbenchStreams, standardErrorThatIsClosedOrFullChangesNoStatus) {
    const std::string soupless = "'" CULLBENCH "' ";
    for (const char* place : {"2>&-", "2>/dev/full"}) {
        const auto status = [&](const std::string& words) { return shell(soupless + words + " " + place).exitStatus; };
        EXPECT_EQ(status("measure nonsense -s all"), 2) << place;
        EXPECT_EQ(status("frobnicate"), 2) << place;
        EXPECT_EQ(status("measure " + file("absent.obj") + " -s all"), 3) << place;
        EXPECT_EQ(shell(kMeasure + " --json - >" + file("a.json") + " " + place).exitStatus, 0) << place;
        EXPECT_TRUE(isWholeJson("a.json")) << place;
        EXPECT_EQ(shell(kMeasure + " --json " + file("b.json") + " " + place).exitStatus, 0) << place;
        EXPECT_TRUE(isWholeJson("b.json")) << place;
    }
}

TEST_F(CullbenchStreams, standardOutputThatIsClosedOrFullIsStatus2AndCostsNoFile) {
    for (const char* place : {">&-", ">/dev/full", ">&- 2>&-", "<&- >&- 2>&-"}) {
        EXPECT_EQ(shell(kMeasure + " --json " + file("a.json") + " " + place).exitStatus, 2) << place;
        EXPECT_TRUE(isWholeJson("a.json")) << place;
        EXPECT_EQ(shell("'" CULLBENCH "' --help " + std::string(place)).exitStatus, 2) << place;
    }
}

TEST_F(CullbenchStreams, interruptBeforeTheFirstViewLeavesTheOldResult) {
    std::ofstream soup(file("soup.obj"));
    for (int i = 0; i < 2'000; ++i) {
        for (int corner = 0; corner < 3; ++corner)
            soup << "v " << std::sin(3 * i + corner) << ' ' << std::cos(7 * i + 2 * corner) << ' '
                 << std::sin(11 * i + 5 * corner) << '\n';
        soup << "f -3 -2 -1\n";
    }
    soup.close();
    // The first frame sorts for minutes.
    for (const char* command : {"measure", "sweep"}) {
        std::ofstream(file("old.json")) << "old";
        std::vector<std::string> words{command,  file("soup.obj"), "-s",     "painter:limit=100000000",
                                       "--path", "fibonacci:1",    "--json", file("old.json")};
        if (words[0] == "sweep") words.insert(words.end(), {"--vary", "sort=newell"});
        const ProcessResult result = cullbench(words, {}, 3.0);
        EXPECT_EQ(result.exitStatus, 130) << command << result.err;
        EXPECT_THAT(result.err, HasSubstr("before anything was measured")) << command;
        EXPECT_EQ(contents("old.json"), "old") << command;
    }
}

TEST_F(CullbenchStreams, closedTerminalKeepsWhatWasMeasuredUnlessItIsToBeIgnored) {
    const auto hungUp = [&](const std::string& prefix, int views, const std::string& json, int seconds) {
        return shell(prefix + "'" CULLBENCH "' measure sphere:triangles=20 -s all --path fibonacci:" + std::to_string(views) +
                     " --size 16x16 --repeat 1 --json " + file(json) + " & p=$!; sleep " + std::to_string(seconds) +
                     "; kill -HUP $p; wait $p");
    };
    // On a busy machine nothing may be measured after two seconds; then no file is written.
    for (int seconds = 2; !std::filesystem::exists(file("part.json")); seconds *= 2) {
        ASSERT_LT(seconds, 100);
        // So many views that they are not all measured before a signal that comes late.
        ASSERT_EQ(hungUp("", 100'000, "part.json", seconds).exitStatus, 130);
    }
    const nlohmann::json part = nlohmann::json::parse(contents("part.json"));
    EXPECT_EQ(part["interrupted"], true);
    EXPECT_GT(part["runs"][0]["frames"].size(), 0u);
    EXPECT_EQ(hungUp("nohup ", 12'000, "whole.json", 2).exitStatus, 0);
    EXPECT_EQ(nlohmann::json::parse(contents("whole.json"))["interrupted"], false);
}

TEST_F(CullbenchStreams, whatStandsInAFileDoesNotReachTheTerminalAsACommand) {
    std::ofstream(file("esc.obj")) << "o \x1B]0;title\x07\x1B[2Jhello\nv 0 0 0\nv 1e-31 0 0\nv 0 1e-31 0\nf 1 2 3\n";
    std::ofstream(file("esc.ply"), std::ios::binary)
        << "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
           "element \x1B]0;title\x07 2\nproperty list uchar uchar q\nend_header\n"
        << std::string(13, '\0');
    std::ofstream(file("esc\x1B[31m.obj")) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 1\n";
    for (const char* name : {"esc.obj", "esc.ply", "esc\x1B[31m.obj", "absent\x1B[31m.obj"}) {
        const ProcessResult result = cullbench({"inspect", file(name), "-s", "all"});
        EXPECT_THAT(result.out + result.err, Not(HasSubstr("\x1B"))) << name;
        EXPECT_THAT(result.out + result.err, HasSubstr("?")) << name;
    }
}

TEST_F(CullbenchStreams, dataOnATerminalCommandItNothing) {
    const std::string name =
        "name\x1B[31m\x7F\xC2\x9B"
        "31m\n.obj";
    std::ofstream(file(name)) << "o part\x1B[31m\x7F\xC2\x9B"
                                 "31m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const std::string scene = file(name);
    const std::vector<std::string> few{"--path", "orbit:1", "--size", "16x16", "--repeat", "1"};
    const std::vector<std::vector<std::string>> lines{{"inspect", scene, "-s", "all", "--json", "-"},
                                                      {"inspect", scene, "-s", "all"},
                                                      {"export", scene, "-o", "-"},
                                                      {"measure", scene, "-s", "all", "--json", "-"},
                                                      {"measure", scene, "-s", "all", "--csv", "-"},
                                                      {"sweep", scene, "-s", "spherical", "--vary", "rows=45", "--svg", "-"},
                                                      {"sweep", scene, "-s", "spherical", "--vary", "rows=45", "--json", "-"}};
    for (std::vector<std::string> line : lines) {
        if (line[0] == "measure" || line[0] == "sweep") line.insert(line.end(), few.begin(), few.end());
        const ProcessResult result = cullbench(line);
        EXPECT_EQ(result.exitStatus, 0) << line[0] << result.err;
        // In a cell of CSV a line may end, and JSON says it with other letters.
        EXPECT_EQ(cullscope::terminalText(result.out + result.err), result.out + result.err) << line[0];
        if (line.back() == "-" && line[0] == "inspect") {
            EXPECT_EQ(nlohmann::json::parse(result.out)["scene"]["name"], name) << "it is escaped, and not another one";
        }
    }
}

TEST_F(CullbenchStreams, aSentenceStaysOnItsLineWhateverItNames) {
    for (const std::vector<std::string>& line : std::vector<std::vector<std::string>>{{"inspect", "a\nb", "-s", "all"},
                                                                                      {"inspect", "./a\nb.obj", "-s", "all"},
                                                                                      {"inspect", "quiz", "-s", "a\nb"},
                                                                                      {"export", "quiz", "-o", "a\nb.xyz"}}) {
        const ProcessResult result = cullbench(line);
        EXPECT_THAT(result.err, testing::StartsWith("cullbench: "));
        EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
    const ProcessResult usage = cullbench({"list", "a\nb"});
    EXPECT_EQ(usage.err, "cullbench: what: a?b not in {scenes,strategies,experiments}\nRun with --help for more information.\n");
}

}  // namespace
}  // namespace cullbench_streams_test
