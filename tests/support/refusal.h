#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/base/error.h"

namespace cullscope::test {

/// The sentence with which some work is refused; empty where it is not.
template <typename Work>
std::string refusalOf(const Work& work, ErrorKind kind) {
    try {
        work();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), kind) << error.what();
        return error.what();
    }
    return {};
}

}  // namespace cullscope::test
