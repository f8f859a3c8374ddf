#pragma once

#include <cstdlib>
#include <string>

namespace cullscope::test {

/// Whether tests with many views take all of them (packaging/test --long) or their fixed sample.
inline bool longMode() {
    const char* value = std::getenv("CULLSCOPE_LONG");
    return value != nullptr && std::string(value) == "1";
}

}  // namespace cullscope::test
