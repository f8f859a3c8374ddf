#include "core/experiments/store/result_store.h"

#include <gtest/gtest.h>

#include <barrier>
#include <filesystem>
#include <thread>
#include <vector>

#include "core/base/error.h"
#include "tests/support/long_mode.h"

namespace cullscope::test::result_store_test {
namespace {

class ResultStores : public testing::Test {
protected:
    void SetUp() override {
        std::string pattern = (std::filesystem::temp_directory_path() / "cullscope-store-XXXXXX").string();
        ASSERT_NE(mkdtemp(pattern.data()), nullptr);
        m_folder = pattern;
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }

    std::filesystem::path m_folder;
};

TEST_F(ResultStores, thatSeveralMakeAtTheSameMomentAreOpenedByEach) {
    constexpr size_t kMakers = 12;
    const uint64_t rounds = howMany(1'000, 40);
    for (uint64_t round = 0; round < rounds; ++round) {
        const std::filesystem::path file = m_folder / std::to_string(round);
        std::barrier atOnce(kMakers);
        std::vector<std::string> refusals(kMakers);
        {
            std::vector<std::jthread> makers;
            for (std::string& refusal : refusals)
                makers.emplace_back([&] {
                    atOnce.arrive_and_wait();
                    try {
                        const store::ResultStore opened(file, store::Database::Access::Write);
                    } catch (const Error& error) {
                        refusal = error.what();
                    }
                });
        }
        for (const std::string& refusal : refusals) ASSERT_EQ(refusal, "") << "round " << round;
    }
}

}  // namespace
}  // namespace cullscope::test::result_store_test
