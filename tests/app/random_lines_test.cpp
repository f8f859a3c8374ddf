// Command lines put together at random of valid and hostile pieces: whatever is asked for, cullbench ends by itself, in time,
// with the status of its table, and leaves no half of a file.

#include "tests/app/random_lines.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/long_mode.h"

namespace cullbench_random_lines_test {
namespace {

using namespace cullbench_random_lines;
using cullscope::test::CommandEnd;
using cullscope::test::CommandLine;

constexpr uint64_t kLines = 2000, kSample = 120;
/// The lines are run in so many cases, which CTest spreads over processors.
constexpr uint64_t kCases = 4;
constexpr double kMostSeconds = 60.0;

std::string contents(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

bool isWhole(const std::filesystem::path& file) {
    const std::string text = contents(file), ending = file.extension();
    if (ending == ".json") return nlohmann::json::accept(text);
    if (ending == ".png") return text.find("IEND") == text.size() - 8;
    return !text.empty() && (ending == ".ply" || ending == ".stl" || ending == ".jpg" || text.back() == '\n');
}

/// What is wrong with the files that the line left; empty: nothing.
std::string faultOfFiles(const RandomLine& random, const CommandEnd& end) {
    if (random.line.folderGone) return "";
    for (const auto& entry : std::filesystem::directory_iterator(end.folder)) {
        const std::string name = entry.path().filename();
        if (std::ranges::find(random.outputs, name) == random.outputs.end()) return "it leaves the file " + name;
        if (!isWhole(entry.path())) return "it leaves half of the file " + name;
    }
    if (end.status != 0) return "";
    for (const std::string& name : random.outputs) {
        const bool named = std::ranges::find(random.line.words, name) != random.line.words.end();
        if (named && !std::filesystem::exists(end.folder / name)) return "it does not write the file " + name;
    }
    return "";
}

std::string faultOf(const RandomLine& random, const CommandEnd& end) {
    if (const std::string fault = cullscope::test::faultOf("cullbench", random.line, end); !fault.empty()) return fault;
    if (!random.statuses.contains(end.status)) return "its status is not the right one";
    return faultOfFiles(random, end);
}

class CullbenchRandomLines : public testing::TestWithParam<uint64_t> {};

TEST_P(CullbenchRandomLines, endByThemselvesWithTheRightStatusAndWholeFiles) {
    const std::filesystem::path folder = std::filesystem::temp_directory_path() /
                                         ("cullbench-lines-" + std::to_string(getpid()) + "-" + std::to_string(GetParam()));
    writeInputs(folder / "in");
    std::vector<RandomLine> random;
    std::vector<CommandLine> lines;
    std::vector<uint64_t> seeds;
    for (uint64_t seed = GetParam(); seed < cullscope::test::howMany(kLines, kSample); seed += kCases) {
        random.push_back(randomLine(seed));
        lines.push_back(random.back().line);
        seeds.push_back(seed);
    }
    cullscope::test::runCommandLines(CULLBENCH, lines, folder, 1, kMostSeconds, [&](size_t i, const CommandEnd& end) {
        const std::string fault = faultOf(random[i], end);
        if (fault.empty()) return;
        std::string expected;
        for (const int status : random[i].statuses) expected += " " + std::to_string(status);
        ADD_FAILURE() << "seed " << seeds[i] << ": " << lines[i].text("cullbench") << "\n  " << fault << "\n  status "
                      << end.status << ", may be:" << expected << "\n  " << end.err.substr(0, 1000);
    });
    std::filesystem::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Parts, CullbenchRandomLines, testing::Range(uint64_t{0}, kCases));

}  // namespace
}  // namespace cullbench_random_lines_test
