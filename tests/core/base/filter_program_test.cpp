#include "core/base/filter_program.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/base/error.h"
#include "tests/support/refusal.h"

namespace cullscope::test::filter_program_test {
namespace {

using testing::HasSubstr;

Filtered byShell(const std::string& script, std::string_view input = {}, const Progress& progress = {}) {
    return runFilter("/bin/sh", std::array<std::string, 2>{"-c", script}, input, progress);
}

TEST(FilterProgram, hasItsInputWhole) {
    std::string input(1'000'000, '\0');
    for (size_t i = 0; i < input.size(); ++i) input[i] = char(i * i % 251);
    const Filtered made = runFilter("/bin/cat", {}, input, {});
    EXPECT_TRUE(made.output == input);
    EXPECT_EQ(made.errors, "");
    EXPECT_EQ(made.status, 0);
    EXPECT_EQ(runFilter("/bin/cat", {}, {}, {}).output, "");
}

TEST(FilterProgram, itsArgumentsArePassedAsTheyAre) {
    EXPECT_EQ(runFilter("/bin/echo", std::array<std::string, 2>{"a  b", "$HOME"}, {}, {}).output, "a  b $HOME\n");
}

TEST(FilterProgram, standardErrorIsKeptApart) {
    const Filtered made = byShell("echo out; echo err >&2");
    EXPECT_EQ(made.output, "out\n");
    EXPECT_EQ(made.errors, "err\n");
}

TEST(FilterProgram, itsStatusIsThatOfItsExitOrMinusOneAfterASignal) {
    EXPECT_EQ(byShell("exit 7").status, 7);
    const Filtered killed = byShell("echo before; kill -SEGV $$");
    EXPECT_EQ(killed.status, -1);
    EXPECT_EQ(killed.output, "before\n");
}

TEST(FilterProgram, aProgramThatDoesNotExistIsRefused) {
    EXPECT_THAT(refusalOf([] { (void)runFilter("/nowhere/program", {}, "input", {}); }, ErrorKind::Usage),
                HasSubstr("/nowhere/program cannot be started"));
}

TEST(FilterProgram, aStopRequestEndsIt) {
    const std::filesystem::path file = std::filesystem::temp_directory_path() / ("cullscope-filter-" + std::to_string(getpid()));
    std::stop_source source;
    std::thread stopper([&] {
        while (!std::filesystem::exists(file)) std::this_thread::yield();
        source.request_stop();
    });
    EXPECT_NE(refusalOf(
                  [&] {
                      (void)byShell("echo $$ > '" + file.string() + ".part'; mv '" + file.string() + ".part' '" + file.string() +
                                        "'; exec sleep 600",
                                    {}, Progress{nullptr, source.get_token()});
                  },
                  ErrorKind::Interrupted),
              "");
    stopper.join();
    pid_t process = 0;
    std::ifstream(file) >> process;
    ASSERT_GT(process, 0);
    EXPECT_EQ(kill(process, 0), -1) << "it is gone";
    std::filesystem::remove(file);
}

TEST(FilterProgram, filesOfTheLibraryLieBesideTheFolderOfPrograms) {
    EXPECT_TRUE(std::filesystem::exists(ownLibraryFile("ifc_to_gltf"))) << ownLibraryFile("ifc_to_gltf");
}

}  // namespace
}  // namespace cullscope::test::filter_program_test
