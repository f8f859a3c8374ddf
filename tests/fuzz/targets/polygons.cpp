#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void polygons(std::string_view input) {
    readSceneFile(input, "input.polygons", [](const Scene& scene) {
        if (scene.remarks().camera) View(*scene.remarks().camera, {64, 48});
    });
}

}  // namespace cullscope::fuzz
