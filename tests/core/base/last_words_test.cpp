#include "core/base/last_words.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdlib>
#include <new>
#include <optional>
#include <thread>

#include "tests/support/peak_memory.h"

namespace cullscope {
namespace {

void failing() { throw std::bad_alloc(); }
/// A function that must not throw, as libraries have them.
void callWithoutThrowing(void (*work)()) noexcept { work(); }

/// As in a process that has used up what `ulimit -v` allows.
void takeAwayMemory() {
    const rlimit none{1, 1};
    setrlimit(RLIMIT_AS, &none);
}

void crash(int signal) {
    const rlimit withoutCoreFile{0, 0};
    setrlimit(RLIMIT_CORE, &withoutCoreFile);
    std::raise(signal);
}

const std::string kSaid = "base_test: It cannot go on, most likely for want of memory or threads";

TEST(LastWords, whatNobodyCatchesEndsWithASentenceAndTheStatusOfInput) {
    const testing::ExitedWithCode input(3);
    EXPECT_EXIT((endWithSentenceOnTerminate(), callWithoutThrowing(failing)), input, kSaid);
    EXPECT_EXIT((endWithSentenceOnTerminate(), std::thread(failing).join()), input, kSaid);
}

TEST(LastWords, crashesForWantOfMemoryEndWithASentenceAndOthersByTheirSignal) {
    if (!test::memoryIsTheWorks())
        GTEST_SKIP() << "The address sanitizer ends a program without memory by itself; the development build's run of this case "
                        "looks at the handler.";
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE, SIGTRAP}) {
        EXPECT_EXIT((endWithSentenceOnWant(), takeAwayMemory(), crash(signal)), testing::ExitedWithCode(3), kSaid) << signal;
        EXPECT_EXIT((endWithSentenceOnWant(), crash(signal)), testing::KilledBySignal(signal), "") << signal;
    }
}

/// As `main` does in which a library exits, by itself or, with the watch over, by returning.
void exitWith(int status, bool watched) {
    std::optional<ExitsForWant> exits(std::in_place);
    if (!watched) exits.reset();
    std::exit(status);
}

TEST(LastWords, exitsForWantOfMemoryEndWithASentenceWhileTheyAreWatched) {
    EXPECT_EXIT((takeAwayMemory(), exitWith(2, true)), testing::ExitedWithCode(3), kSaid);
    // An exit that goes on is followed by the address sanitizer's search for leaks, which ends without memory by itself.
    if (test::memoryIsTheWorks()) EXPECT_EXIT((takeAwayMemory(), exitWith(2, false)), testing::ExitedWithCode(2), "");
}

TEST(LastWords, exitsWithMemoryToSpareEndAsTheyAsk) {
    EXPECT_EXIT(exitWith(2, true), testing::ExitedWithCode(2), "^$");
    EXPECT_EXIT(exitWith(0, true), testing::ExitedWithCode(0), "^$");
}

}  // namespace
}  // namespace cullscope
