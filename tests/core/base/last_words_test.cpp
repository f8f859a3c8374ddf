#include "core/base/last_words.h"

#include <gtest/gtest.h>

#include <new>
#include <thread>

namespace cullscope {
namespace {

void failing() { throw std::bad_alloc(); }
/// A function that must not throw, as libraries have them.
void callWithoutThrowing(void (*work)()) noexcept { work(); }

TEST(LastWords, whatNobodyCatchesEndsWithASentenceAndTheStatusOfInput) {
    const testing::ExitedWithCode input(3);
    const char* said = "base_test: It cannot go on, most likely for want of memory or threads";
    EXPECT_EXIT((endWithSentenceOnTerminate(), callWithoutThrowing(failing)), input, said);
    EXPECT_EXIT((endWithSentenceOnTerminate(), std::thread(failing).join()), input, said);
}

}  // namespace
}  // namespace cullscope
