#include "core/scene/scene_source.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

/// In place of the bunny, which is read for fields and splits that name no mesh.
constexpr std::string_view kSmallBunny = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

}  // namespace

void generator(std::string_view input) {
    static const SceneSourceOptions kOptions = [] {
        SceneSourceOptions options;
        options.modelFolders = {fileOf(kSmallBunny, "bunny.obj").parent_path()};
        options.load.memoryLimitBytes = 100'000;  // scenes that take longer than a moment are refused
        std::filesystem::current_path(scratchFolder());
        return options;
    }();
    // Devices and files of the system do not belong to the input.
    if (input.find('/') != std::string_view::npos) return;
    accepted({ErrorKind::Usage, ErrorKind::Input}, [&] { requireSound(*openScene(input, kOptions).scene); });
}

}  // namespace cullscope::fuzz
