#include <algorithm>
#include <numeric>

#include "core/spatial/instance_octree.h"
#include "core/spatial/regular_octree.h"
#include "tests/fuzz/small_scene.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

void requireEachOnce(std::vector<uint32_t> order, const Scene& scene) {
    std::ranges::sort(order);
    std::vector<uint32_t> shown;
    for (uint32_t i = 0; i < scene.instances().size(); ++i)
        if (scene.meshOf(i).triangleCount() > 0) shown.push_back(i);
    require(order == shown, "an octree has not each instance once");
}

template <typename Tree>
void requireChildrenAfterParents(const Tree& tree) {
    const auto& nodes = tree.nodes();
    for (size_t i = 0; i < nodes.size(); ++i) {
        require(tree.instancesOf(nodes[i]).size() == nodes[i].count, "a node has other instances than it says");
        if (nodes[i].leaf()) continue;
        require(nodes[i].firstChild > i && nodes[i].firstChild + nodes[i].childCount <= nodes.size(), "a child is no node");
    }
}

}  // namespace

void octree(std::string_view input) {
    Values values(input);
    const auto leafInstances = uint32_t(1 + values.below(8));
    const int levels = int(1 + values.below(RegularOctree::kMostLevels));
    const ScenePointer scene = sceneOf(values);
    if (!scene) return;
    const InstanceOctree tree(*scene, leafInstances);
    requireEachOnce(tree.order(), *scene);
    requireChildrenAfterParents(tree);
    std::vector<uint32_t> instances(scene->instances().size());
    std::iota(instances.begin(), instances.end(), 0U);
    const RegularOctree regular(*scene, instances, levels);
    requireEachOnce(regular.order(), *scene);
    requireChildrenAfterParents(regular);
}

}  // namespace cullscope::fuzz
