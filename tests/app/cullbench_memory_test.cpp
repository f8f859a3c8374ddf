// Less memory or threads than OpenGL's driver, the picture formats and the scene need: one sentence and status 3, whatever of
// them crashes or waits.

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/support/command_lines.h"

namespace cullbench_memory_test {
namespace {

using cullscope::test::CommandEnd;
using cullscope::test::CommandLine;

TEST(CullbenchMemory, thatIsWantingIsSaidAndNoCrash) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("cullbench-memory-" + std::to_string(getpid()));
    const std::vector<std::vector<std::string>> commands{
        {"measure", "sphere:triangles=2000", "-s", "all", "--path", "orbit:1", "--size", "32x32", "--repeat", "1"},
        {"render", "sphere:triangles=2000", "-s", "all", "--size", "32x32", "-o", "out.png"}};
    std::vector<CommandLine> lines;
    for (const std::vector<std::string>& words : commands)
        for (const uint64_t megabytes : {100, 200, 290, 350, 440, 500, 600, 700, 1000, 4000}) {
            CommandLine line;
            line.words = words;
            line.mostMemory = megabytes << 20;
            lines.push_back(line);
        }
    cullscope::test::runCommandLines(CULLBENCH, lines, folder, 1, 60.0, [&](size_t i, const CommandEnd& end) {
        EXPECT_EQ(cullscope::test::faultOf("cullbench", lines[i], end, cullscope::test::Said::ByLibraries), "")
            << lines[i].text("cullbench") << end.err;
        const bool small = lines[i].mostMemory<(uint64_t{250} << 20), ample = lines[i].mostMemory>(uint64_t{2} << 30);
        EXPECT_TRUE(end.status == (ample ? 0 : 3) || (!small && end.status == 0))
            << lines[i].text("cullbench") << end.status << end.err;
        EXPECT_EQ(std::filesystem::exists(end.folder / "out.png"), end.status == 0 && lines[i].words[0] == "render");
    });
}

TEST(CullbenchMemory, threadsThatAreWantingAreSaidAndNotWaitedFor) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("cullbench-threads-" + std::to_string(getpid()));
    std::vector<CommandLine> lines;
    for (const uint64_t threads : {1, 2, 3, 5}) {
        CommandLine line;
        line.words = {"measure", "sphere:triangles=2000", "-s", "all", "--path", "orbit:1", "--size", "32x32", "--repeat", "1"};
        line.mostThreads = threads;
        lines.push_back(line);
    }
    cullscope::test::runCommandLines(CULLBENCH, lines, folder, 1, 60.0, [&](size_t i, const CommandEnd& end) {
        // A program in a private folder cannot be started by the user for whom the limit holds.
        if (end.status == 126 || end.status == 127) return;
        EXPECT_EQ(cullscope::test::faultOf("cullbench", lines[i], end, cullscope::test::Said::ByLibraries), "")
            << lines[i].text("cullbench") << end.err;
        EXPECT_EQ(end.status, 3) << lines[i].text("cullbench") << end.err;
    });
}

}  // namespace
}  // namespace cullbench_memory_test
