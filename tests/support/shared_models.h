#pragma once

#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace cullscope::test {

/// A scene of ../shared/models/scenes, unpacked where its name ends with ".xz"; none where it is not there: these models are
/// other people's and not part of this repository. Fails the test where it cannot be unpacked.
[[nodiscard]] std::optional<ScenePointer> sharedScene(const std::string& name);

}  // namespace cullscope::test
