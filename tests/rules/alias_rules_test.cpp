#include <unistd.h>

#include <fstream>

#include "tests/rules/source_rules.h"

namespace cullscope::rules::alias_rules_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(AliasRules, aliasOfAFunctionThatASourceOfItsLibraryDeclaresIsReported) {
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

TEST(AliasRules, aliasesOfTheProjectHideNone) { EXPECT_THAT(aliasOffences(CULLSCOPE_SOURCE_DIR), IsEmpty()); }

}  // namespace
}  // namespace cullscope::rules::alias_rules_test
