#include "core/base/memory_limit.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

namespace cullscope {
namespace {

TEST(MemoryLimit, aLimitedAddressSpaceIsPlannedWith) {
    const uint64_t before = memoryToPlanWith();
    EXPECT_GT(before, uint64_t{64} << 20);
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &usual), 0);
    rlimit limited = usual;
    limited.rlim_cur = before / 2;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
    const uint64_t planned = memoryToPlanWith();
    ASSERT_EQ(setrlimit(RLIMIT_AS, &usual), 0);
    EXPECT_EQ(planned, before / 2 / 4 * 3);
    EXPECT_EQ(memoryToPlanWith(), before);
}

TEST(MemoryLimit, isShortWhereHalfAGigabyteIsRefused) {
    EXPECT_FALSE(memoryIsShort());
    EXPECT_FALSE(threadsAreShort());
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_AS, &usual), 0);
    rlimit limited = usual;
    limited.rlim_cur = 1;
    ASSERT_EQ(setrlimit(RLIMIT_AS, &limited), 0);
    const bool isShort = memoryIsShort();
    ASSERT_EQ(setrlimit(RLIMIT_AS, &usual), 0);
    EXPECT_TRUE(isShort);
}

}  // namespace
}  // namespace cullscope
