#pragma once

#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace cullscope::test {

/// A scene of ../shared/models/scenes; none where it is not there: these models are other people's and not part of this
/// repository.
[[nodiscard]] std::optional<ScenePointer> sharedScene(const std::string& name);

}  // namespace cullscope::test
