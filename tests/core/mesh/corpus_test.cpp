// Every malformed file loads or is refused with one sentence; none crashes, hangs or allocates memory by a count that it states.
#include <algorithm>

#include "tests/support/mesh_files.h"

namespace cullscope::test::corpus_test {
namespace {

constexpr unsigned kSecondsForAFile = 20;

const std::filesystem::path kOwnCorpus = CULLSCOPE_SOURCE_DIR "/tests/core/mesh/data";
const std::filesystem::path kSharedCorpus = CULLSCOPE_SOURCE_DIR "/../shared/malformed";

std::vector<std::filesystem::path> filesUnder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

void expectEachLoadsOrIsRefused(const std::filesystem::path& folder, size_t atLeastLoaded) {
    size_t loaded = 0;
    for (const std::filesystem::path& file : filesUnder(folder)) {
        const Outcome outcome = loadInChild({file}, kSecondsForAFile).front();
        EXPECT_NE(outcome, Outcome::Wrong) << file;
        loaded += outcome == Outcome::Loaded ? 1 : 0;
    }
    EXPECT_GE(loaded, atLeastLoaded);
}

TEST(MalformedFiles, ownCorpusLoadsOrIsRefused) { expectEachLoadsOrIsRefused(kOwnCorpus, 6); }

TEST(MalformedFiles, collectedCorpusLoadsOrIsRefused) {
    if (!std::filesystem::is_directory(kSharedCorpus))
        GTEST_SKIP()
            << "The collected files, ../shared/malformed, are other people's and not part of this repository; files of the same "
               "faults, written for it, are read by ownCorpusLoadsOrIsRefused.";
    expectEachLoadsOrIsRefused(kSharedCorpus, 6);
}

}  // namespace
}  // namespace cullscope::test::corpus_test
