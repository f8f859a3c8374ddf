#pragma once

#include <cstddef>
#include <functional>

namespace cullscope::test {

/// Whether peakBytesOf says what the work itself takes: the address sanitizer keeps freed memory for some time.
#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kMemoryIsTheWorks = false;
#elif defined(__has_feature)
inline constexpr bool kMemoryIsTheWorks = !__has_feature(address_sanitizer);
#else
inline constexpr bool kMemoryIsTheWorks = true;
#endif

/// The most memory in bytes that the work holds at any time beyond what the process held before. The work is done in a child
/// process; an exception that leaves it is dropped.
[[nodiscard]] size_t peakBytesOf(const std::function<void()>& work);

}  // namespace cullscope::test
