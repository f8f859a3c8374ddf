#include "tests/rules/reach.h"

#include <unistd.h>

#include <fstream>

namespace cullscope::rules::reach_test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// Two strategies, what they share, and tests, in a temporary folder.
class Reach : public testing::Test {
protected:
    Reach() : m_root(fs::temp_directory_path() / ("cullscope reach " + std::to_string(getpid()))) {
        write("core/geometry/bounds.h", "");
        write("core/visibility/frustum/octree.h", "");
        write("core/visibility/frustum/octree.cpp", source("frustum/octree") + strategy("frustum-octree"));
        write("core/visibility/frustum/planes.h", "#include \"core/geometry/bounds.h\"\n");
        write("core/visibility/frustum/planes.cpp", source("frustum/planes") + strategy("frustum"));
        write("core/visibility/registry.h", "");
        write("core/visibility/registry.cpp", source("registry") + source("frustum/octree") + source("frustum/planes"));
        write("tests/core/geometry/bounds_test.cpp", "#include \"core/geometry/bounds.h\"\nTEST(Bounds, holdPoints) {}\n");
        write("tests/core/visibility/octree_test.cpp",
              source("registry") + "TEST_F(Octree, culls) { make(\"frustum-octree\"); }\n");
        write("tests/app/planes_test.cpp", "TEST(Planes, cull) { run(\"all,frustum:box=length\"); }\n");
    }
    ~Reach() override {
        std::error_code ignored;
        fs::remove_all(m_root, ignored);
    }

    static std::string source(const std::string& stem) { return "#include \"core/visibility/" + stem + ".h\"\n"; }
    static std::string strategy(const std::string& id) {
        return "StrategyInfo info() { return {}; } xInfo() {\n return {\"" + id + "\"}; }\n";
    }
    void write(const fs::path& file, const std::string& text) const {
        fs::create_directories((m_root / file).parent_path());
        std::ofstream(m_root / file) << text;
    }
    [[nodiscard]] const fs::path& root() const { return m_root; }

private:
    fs::path m_root;
};

TEST_F(Reach, strategyReachesTheTestsThatNameItsId) {
    EXPECT_THAT(testsReached(root(), {"core/visibility/frustum/octree.cpp"}),
                ElementsAre(Pair("visibility", ElementsAre("Octree.culls"))));
    EXPECT_THAT(testsReached(root(), {"core/visibility/frustum/planes.cpp"}),
                ElementsAre(Pair("cullbench", ElementsAre("Planes.cull"))));
}

TEST_F(Reach, strategyThatManyTestsNameReachesThoseOfItsLayerAndFamily) {
    for (int i = 0; i < 20; ++i) {
        const std::string number = std::to_string(i);
        write("tests/ui/example" + number + "_test.cpp", "TEST(Example" + number + ", isDrawn) { open(\"frustum\"); }\n");
    }
    write("tests/core/visibility/frustum/planes_test.cpp", "TEST(Planes, loseNothing) { make(\"frustum\"); }\n");
    write("tests/core/visibility/strategies_test.cpp", "TEST(Strategies, loseNothing) { make(\"frustum\"); }\n");
    write("tests/ui/frustum_family_test.cpp", "TEST(FrustumFamily, isListed) { make(\"frustum\"); }\n");
    EXPECT_THAT(testsReached(root(), {"core/visibility/frustum/planes.cpp"}),
                ElementsAre(Pair("ui", ElementsAre("FrustumFamily.isListed")),
                            Pair("visibility", ElementsAre("Planes.loseNothing", "Strategies.loseNothing"))));
}

TEST_F(Reach, benchmarkReachesTheTestOfBenchmarks) {
    write("tests/benchmark/experiments.h", "");
    write("tests/benchmark/octree.cpp", "#include \"core/geometry/bounds.h\"\n#include \"tests/benchmark/experiments.h\"\n");
    write("tests/benchmark/benchmark_test.cpp", "#include \"tests/benchmark/experiments.h\"\nTEST(Benchmarks, run) {}\n");
    EXPECT_THAT(testsReached(root(), {"tests/benchmark/octree.cpp"}),
                ElementsAre(Pair("benchmark", ElementsAre("Benchmarks.run"))));
}

TEST_F(Reach, headerReachesWhatIncludesIt) {
    EXPECT_THAT(testsReached(root(), {"core/geometry/bounds.h"}),
                ElementsAre(Pair("cullbench", ElementsAre("Planes.cull")), Pair("geometry", ElementsAre("Bounds.holdPoints"))));
}

TEST_F(Reach, testFileReachesItself) {
    EXPECT_THAT(testsReached(root(), {"tests/app/planes_test.cpp"}), ElementsAre(Pair("cullbench", ElementsAre("Planes.cull"))));
    EXPECT_THAT(testsReached(root(), {"docs/using.md"}), IsEmpty());
}

TEST_F(Reach, programsAndSuitesAreFoundByName) {
    EXPECT_THAT(testsNamed(root(), "geometry"), ElementsAre(Pair("geometry", ElementsAre("*"))));
    EXPECT_THAT(testsNamed(root(), "Octree"), ElementsAre(Pair("visibility", ElementsAre("Octree.culls"))));
    EXPECT_THAT(testsNamed(root(), "Nothing"), IsEmpty());
    EXPECT_THAT(testPrograms(root()), ElementsAre("cullbench", "geometry", "visibility"));
}

}  // namespace
}  // namespace cullscope::rules::reach_test
