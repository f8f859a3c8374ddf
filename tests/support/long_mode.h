#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace cullscope::test {

/// Whether tests with many views take all of them (packaging/test --long) or their fixed sample.
inline bool longMode() {
    const char* value = std::getenv("CULLSCOPE_LONG");
    return value != nullptr && std::string(value) == "1";
}

/// Whether samples are small (CULLSCOPE_FEW=1), as under the sanitizers, which look for errors of memory in the same code and not
/// for rare views.
inline bool fewSamples() {
    const char* value = std::getenv("CULLSCOPE_FEW");
    return value != nullptr && std::string(value) == "1";
}

/// How many views, rays or pairs a property test takes: all of them in a long run, else its sample; a quarter of that
/// where samples are small.
inline uint64_t howMany(uint64_t all, uint64_t sample) {
    if (longMode()) return all;
    return fewSamples() ? std::max<uint64_t>(1, sample / 4) : sample;
}

}  // namespace cullscope::test
