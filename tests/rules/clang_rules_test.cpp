#include <unistd.h>

#include <fstream>

#include "tests/rules/source_rules.h"

namespace cullscope::rules::clang_rules_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(ClangRules, aliasOfAFunctionThatASourceOfItsLibraryDeclaresIsReported) {
    const fs::path root = fs::temp_directory_path() / ("cullscope aliases " + std::to_string(getpid()));
    fs::create_directories(root / "core/mesh/ply");
    fs::create_directories(root / "core/scene");
    std::ofstream(root / "core/mesh/load.cpp") << "using Text = std::string;\n";
    std::ofstream(root / "core/scene/path.cpp") << "void read() {\n    using Text = std::string;\n}\n";
    EXPECT_THAT(aliasOffences(root), IsEmpty());
    std::ofstream(root / "core/mesh/ply/lines.cpp") << "void read() {\n    using Text = std::string;\n}\n";
    EXPECT_THAT(aliasOffences(root),
                ElementsAre(Offence{"core/mesh/ply/lines.cpp", 2, "hides an alias of another source: Text"}));
    fs::remove_all(root);
}

TEST(ClangRules, aliasesOfTheProjectHideNone) { EXPECT_THAT(aliasOffences(CULLSCOPE_SOURCE_DIR), IsEmpty()); }

TEST(ClangRules, rangesThatClangDoesNotCompileAreReported) {
    const fs::path root = fs::temp_directory_path() / ("cullscope ranges " + std::to_string(getpid()));
    fs::create_directories(root / "core/mesh");
    std::ofstream(root / "core/mesh/parts.cpp")
        << "std::ranges::sort(parts);\nfor (Part& part : std::ranges::equal_range(parts, 1)) {\n"
        << "const auto names = parts | std::views::keys;\n";
    EXPECT_THAT(rangesOffences(root),
                ElementsAre(Offence{"core/mesh/parts.cpp", 2, "is not compiled by Clang 14: ranges::equal_range"},
                            Offence{"core/mesh/parts.cpp", 3, "is not compiled by Clang 14: views::keys"}));
    fs::remove_all(root);
}

TEST(ClangRules, theProjectUsesNone) { EXPECT_THAT(rangesOffences(CULLSCOPE_SOURCE_DIR), IsEmpty()); }

}  // namespace
}  // namespace cullscope::rules::clang_rules_test
