#pragma once

#include <cstddef>
#include <functional>

namespace cullscope::test {

/// Whether peakBytesOf says what the work itself takes: the address sanitizer keeps freed memory for some time.
[[nodiscard]] bool memoryIsTheWorks();

/// The most memory in bytes that the work holds at any time beyond what the process held before. The work is done in a child
/// process; an exception that leaves it is dropped.
[[nodiscard]] size_t peakBytesOf(const std::function<void()>& work);

}  // namespace cullscope::test
