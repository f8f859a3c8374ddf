#include "tests/support/shared_models.h"

#include <filesystem>

#include "core/scene/scene_source.h"

namespace cullscope::test {

std::optional<ScenePointer> sharedScene(const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(CULLSCOPE_SOURCE_DIR "/../shared/models/scenes") / name;
    if (!std::filesystem::exists(file)) return std::nullopt;
    return openScene(file.string()).scene;
}

}  // namespace cullscope::test
