#include "tests/support/shared_models.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/scene/scene_source.h"
#include "tests/support/process.h"

namespace cullscope::test {

std::optional<ScenePointer> sharedScene(const std::string& name) {
    const std::filesystem::path file = std::filesystem::path(CULLSCOPE_SOURCE_DIR "/../shared/models/scenes") / name;
    if (!std::filesystem::exists(file)) return std::nullopt;
    if (file.extension() != ".xz") return openScene(file.string()).scene;
    const std::filesystem::path unpacked =
        std::filesystem::path(testing::TempDir()) / ("cullscope-" + std::to_string(getpid()) + "-" + file.stem().string());
    const ProcessResult result = runProcess({"/bin/sh", "-c", "xz -dc '" + file.string() + "' > '" + unpacked.string() + "'"});
    EXPECT_EQ(result.exitStatus, 0) << "xz is in packaging/packages.txt: " << result.err;
    const ScenePointer scene = openScene(unpacked.string()).scene;
    std::filesystem::remove(unpacked);
    return scene;
}

}  // namespace cullscope::test
