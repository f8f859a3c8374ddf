#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "core/scene/scene.h"

namespace cullscope::test {

/// Whether truncations of a file and files with a few seeded changes load into scenes with boxes, or are refused by an
/// Error(Input) that names the file; in a child process with limited memory and time. `open` writes its bytes as `name` and opens
/// that. What is wrong is printed with the round, which gives it again.
[[nodiscard]] bool everyChangeLoadsOrIsRefused(const std::string& good, const std::string& name,
                                               const std::function<ScenePointer(std::string_view bytes)>& open);

}  // namespace cullscope::test
