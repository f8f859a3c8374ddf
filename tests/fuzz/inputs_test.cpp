// Runs every target with its seeds, and with what was found: each fixed error stays a test.
#include <fstream>
#include <iterator>
#include <set>

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Not;

const fs::path kFolder = fs::path(CULLSCOPE_SOURCE_DIR) / "tests/fuzz";

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::is_directory(folder))
        for (const fs::directory_entry& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

std::string contentOf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class FuzzInputs : public testing::TestWithParam<Target> {
protected:
    static void run(const fs::path& folder) {
        for (const fs::path& file : filesIn(folder / GetParam().name)) {
            SCOPED_TRACE(file.string());
            const std::string content = contentOf(file);
            EXPECT_LE(content.size(), kMostBytes) << "the fuzzer would cut it off";
            EXPECT_NO_THROW(GetParam().run(content));
        }
    }
};

TEST_P(FuzzInputs, seedsAreTakenOrRefused) {
    EXPECT_THAT(filesIn(kFolder / "seeds" / GetParam().name), Not(testing::IsEmpty()));
    run(kFolder / "seeds");
}

TEST_P(FuzzInputs, findingsAreMended) { run(kFolder / "findings"); }

TEST_P(FuzzInputs, emptyInputIsTakenOrRefused) { EXPECT_NO_THROW(GetParam().run({})); }

INSTANTIATE_TEST_SUITE_P(Target, FuzzInputs, testing::ValuesIn(targets()),
                         [](const testing::TestParamInfo<Target>& each) { return std::string(each.param.name); });

TEST(FuzzTargets, everySourceAndEveryFolderOfInputsIsATarget) {
    std::set<std::string> names;
    for (const Target& target : targets()) names.insert(target.name);
    for (const fs::path& source : filesIn(kFolder / "targets")) EXPECT_THAT(names, Contains(source.stem().string()));
    for (const char* folder : {"seeds", "findings"})
        for (const fs::path& inputs : filesIn(kFolder / folder)) EXPECT_THAT(names, Contains(inputs.filename().string()));
    for (const fs::path& dictionary : filesIn(kFolder / "dictionaries")) EXPECT_THAT(names, Contains(dictionary.stem().string()));
}

TEST(FuzzTargets, inputThatBreaksWhatIsRequiredIsAFinding) {
    EXPECT_THROW(require(false, "an error"), std::logic_error);
    EXPECT_FALSE(accepted({ErrorKind::Usage}, [] { throwUsage("no"); }));
    EXPECT_TRUE(accepted({ErrorKind::Usage}, [] {}));
    EXPECT_THROW(accepted({ErrorKind::Usage}, [] { throwInput("no"); }), std::logic_error);
    EXPECT_THROW(accepted({ErrorKind::Usage}, [] { throw std::bad_alloc(); }), std::bad_alloc);
    EXPECT_THROW(acceptedFile("input.obj", [] { throwInput("another.obj is no mesh."); }), std::logic_error);
    EXPECT_FALSE(acceptedFile("input.obj", [] { throwInput("input.obj is no mesh."); }));
}

}  // namespace
}  // namespace cullscope::fuzz
