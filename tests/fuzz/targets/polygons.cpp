#include "core/scene/polygon_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void polygons(std::string_view input) {
    const std::filesystem::path file = fileOf(input, "input.polygons");
    acceptedFile(file, [&] {
        LoadOptions options;
        options.memoryLimitBytes = kMemory;
        const PolygonScene read = readPolygonFile(file, options);
        requireSound(*read.scene);
        if (read.scene->remarks().camera) View(*read.scene->remarks().camera, {64, 48});
    });
}

}  // namespace cullscope::fuzz
