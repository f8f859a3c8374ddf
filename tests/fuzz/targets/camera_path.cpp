#include "core/scene/camera_path.h"

#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void camera_path(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "input.json");
    CameraPath path;
    if (!acceptedFile(file, [&] { path = readCameraPath(file); })) return;
    require(!path.poses.empty(), "a path without poses");
    // What was accepted gives views.
    for (size_t pose = 0; pose < path.poses.size(); ++pose) (void)View(path.camera(pose), {64, 48}).frustum();
}

}  // namespace cullscope::fuzz
