#pragma once

#include <string>

namespace cullscope {

/// The short hash of the commit that this was built from, with "-dirty" where tracked files were changed; "unknown" outside a
/// checkout.
[[nodiscard]] std::string buildCommit();

}  // namespace cullscope
