// The programs: what they print and write, their exit statuses, and those that time the window.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

#include "tests/benchmark/run_experiment.h"
#include "tests/support/process.h"

namespace cullscope::benchmark::benchmark_programs_test {
namespace {

/// What the programs print and write, by a made-up experiment.
struct Reports : testing::Test {
    void SetUp() override {
        folder = std::filesystem::temp_directory_path() / ("benchmark-test-" + std::to_string(getpid()));
        experiment.id = "made-up";
        experiment.title = "Made up";
        experiment.axes = {{"n", "n", Axis::Kind::Label, {1.0, 2.0, 4.0}}};
        experiment.settings = settingsOf(experiment.axes);
        experiment.columns = columnsOf(experiment.axes);
        experiment.columns.push_back({"ms", "ms"});
        experiment.plots = {RowPlot{logPlot("Time", "n", "ms"), "n", {{"ms"}}}};
        experiment.measured = [](const Setting& setting, const ScenePointer&, const Progress&) {
            return Rows{{{"ms", setting.number("n") * setting.number("n")}}};
        };
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    [[nodiscard]] std::string contents(const std::string& name) const {
        std::ifstream in(folder / name);
        return {std::istreambuf_iterator<char>(in), {}};
    }

    std::filesystem::path folder;
    Experiment experiment;
};

TEST_F(Reports, tableAndPlotsAreWritten) {
    EXPECT_EQ(runAndReport({experiment, folder / "inner"}), 0);
    EXPECT_EQ(contents("inner/made-up.csv"), "n,ms\n1,1\n2,4\n4,16\n");
    EXPECT_TRUE(contents("inner/made-up.svg").starts_with("<svg"));
}

TEST_F(Reports, whatDeclaresTooLittleIsNotRun) {
    experiment.axes.clear();
    EXPECT_THROW((void)runAndReport({experiment, folder}), std::logic_error);
    experiment = Experiment();
    EXPECT_THROW((void)runAndReport({experiment, folder}), std::logic_error);
}

TEST_F(Reports, checkThatDoesNotHoldGivesStatus1AndTheFilesAreThere) {
    experiment.checks = {exponentCheck("time grows with n to the power of", {{}, "n", "ms"}, {.most = 1.5})};
    testing::internal::CaptureStdout();
    EXPECT_EQ(runAndReport({experiment, folder}), 1);
    EXPECT_THAT(testing::internal::GetCapturedStdout(),
                testing::HasSubstr("time grows with n to the power of: 2 (at most 1.5), DOES NOT HOLD"));
    EXPECT_FALSE(contents("made-up.csv").empty());
}

TEST_F(Reports, failureGivesStatus2AndNoFile) {
    experiment.measured = [](const Setting&, const ScenePointer&, const Progress&) -> Rows { throw std::runtime_error("no"); };
    const RunOfArguments runOf = [this](const std::vector<std::string>& arguments) -> std::optional<BenchmarkRun> {
        if (arguments.size() != 1) return std::nullopt;
        return BenchmarkRun{experiment, folder};
    };
    std::string program = "made_up_benchmark", argument = "FOLDER";
    char* arguments[] = {program.data(), argument.data()};
    EXPECT_EQ(benchmarkMain(2, arguments, "usage", runOf), 2);
    EXPECT_EQ(benchmarkMain(1, arguments, "usage", runOf), 2);
    EXPECT_TRUE(contents("made-up.csv").empty());
}

std::string programPath(const char* name) { return std::string(BENCHMARKS) + "/" + name; }

TEST(BenchmarkPrograms, readersOfPlyAreTimedInProcessesOfTheirOwn) {
    const test::ProcessResult result = test::runProcess({programPath("ply_load_benchmark"), "2000", "1"});
    // So small a file says nothing about the limits.
    EXPECT_THAT(result.exitStatus, testing::AnyOf(0, 1)) << result.err;
    EXPECT_THAT(result.out, testing::HasSubstr("peak memory, of the arrays"));
    EXPECT_EQ(test::runProcess({programPath("ply_load_benchmark"), "none"}).exitStatus, 2);
}

TEST(BenchmarkPrograms, refuseWhatTheyDoNotKnow) {
    EXPECT_EQ(test::runProcess({programPath("spherical_maps_benchmark")}).exitStatus, 2);
    EXPECT_EQ(test::runProcess({programPath("spherical_lossless_benchmark"), "grow", "FOLDER"}).exitStatus, 2);
}

// Built where the desktop is; there it always runs.
#ifdef BENCHMARKS_WITH_DESKTOP
TEST(BenchmarkPrograms, movesAreTimedInTheWindow) {
    const std::string program = programPath("input_latency_benchmark");
    const test::ProcessResult result = test::runProcess({program, "sphere:triangles=500", "0.1"});
    // Other programs on the machine may take longer than the limit allows.
    EXPECT_THAT(result.exitStatus, testing::AnyOf(0, 1)) << result.err;
    EXPECT_THAT(result.out, testing::HasSubstr("longest wait of a move"));
}

TEST(BenchmarkPrograms, stepsAreTimedInTheWindow) {
    const test::ProcessResult result =
        test::runProcess({programPath("step_latency_benchmark"), "sphere:triangles=500", "spherical", "100", "3"});
    EXPECT_THAT(result.exitStatus, testing::AnyOf(0, 1)) << result.err;
    EXPECT_THAT(result.out, testing::HasSubstr("slowest step"));
}

TEST_F(Reports, stepsOfALessonAreTimedInTheWindow) {
    const test::ProcessResult result =
        test::runProcess({programPath("step_latency_benchmark"), "lessons", folder.string(), "1", "frustum"});
    EXPECT_THAT(result.exitStatus, testing::AnyOf(0, 1)) << result.err;
    std::istringstream csv(contents("lesson-latency.csv"));
    std::string line;
    std::getline(csv, line);
    EXPECT_EQ(line, "lesson,step,views,triangles,times,shown_ms,shown_ms_longest,limit_ms");
    int step = 0;
    while (std::getline(csv, line)) EXPECT_THAT(line, testing::StartsWith("frustum," + std::to_string(++step) + ","));
    EXPECT_EQ(step, 9);
    EXPECT_EQ(test::runProcess({programPath("step_latency_benchmark"), "lessons", folder.string(), "1", "none"}).exitStatus, 2);
}
#endif

}  // namespace
}  // namespace cullscope::benchmark::benchmark_programs_test
