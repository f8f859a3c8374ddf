#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/support/process.h"

namespace cullscope::test {

/// Runs cullbench; with `interruptAfter` above 0 it is interrupted after that many seconds.
inline ProcessResult cullbench(std::vector<std::string> arguments, const std::vector<std::string>& environment = {},
                               double interruptAfter = 0.0) {
    arguments.insert(arguments.begin(), CULLBENCH);
    return runProcess(arguments, environment, interruptAfter);
}

/// A folder for the files of one case.
class CullbenchContract : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() / ("cullbench-test-" + std::to_string(getpid()));
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::string file(const std::string& name) const { return (m_folder / name).string(); }
    [[nodiscard]] size_t filesWritten() const {
        return static_cast<size_t>(
            std::distance(std::filesystem::directory_iterator(m_folder), std::filesystem::directory_iterator()));
    }

private:
    std::filesystem::path m_folder;
};

/// Expects one sentence on standard error that starts with the program's name, and no partial output.
inline void expectRefusal(const ProcessResult& result, int status, const std::string& mentions) {
    EXPECT_EQ(result.exitStatus, status) << result.err;
    EXPECT_THAT(result.err, testing::HasSubstr(mentions));
    EXPECT_EQ(result.out, "");
}

}  // namespace cullscope::test
