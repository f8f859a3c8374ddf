#include "core/spatial/bsp_tree.h"

#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void bsp_tree(std::string_view input) {
    Values values(input);
    BspOptions options;
    options.plane = BspPlane(values.below(4));
    options.candidates = int(1 + values.below(16));
    options.limit = 2000;
    const ScenePointer scene = sceneOf(values);
    if (!scene) return;
    accepted({ErrorKind::Usage}, [&] {
        const BspTree tree(*scene, options);
        std::vector<bool> shown(scene->triangleCount());
        for (const BspTree::Part& part : tree.parts()) {
            require(part.triangle < shown.size(), "a part is of no triangle");
            shown[part.triangle] = true;
        }
        for (const BspTree::Part& part : tree.flatParts()) shown[part.triangle] = true;
        require(std::find(shown.begin(), shown.end(), false) == shown.end(), "a triangle is in no node");
        const Vec3 eye(values.quarter(), values.quarter(), values.quarter());
        std::vector<int> visits(tree.nodes().size()), own(tree.nodes().size());
        tree.walk(
            eye, values.below(2) == 1, [&](uint32_t node, int) { ++visits[node]; }, [&](uint32_t node) { ++own[node]; });
        for (size_t node = 0; node < visits.size(); ++node)
            require(visits[node] == 1 && own[node] == 1, "a walk does not come to each node once");
    });
}

}  // namespace cullscope::fuzz
