#pragma once

#include <string>
#include <string_view>

namespace cullscope::test {

/// The bytes as gzip writes them.
[[nodiscard]] std::string gzipped(std::string_view bytes);
/// The bytes as xz writes them.
[[nodiscard]] std::string xzPacked(std::string_view bytes);

}  // namespace cullscope::test
