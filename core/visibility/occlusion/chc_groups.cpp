#include "core/visibility/occlusion/chc_groups.h"

#include <algorithm>

namespace cullscope::occlusion {
namespace {

constexpr size_t kMostBoxes = 512;

double surfaceOf(const Box3& box) {
    const Vec3 edge = 2.0 * box.halfExtent();
    return 2.0 * (edge.x * edge.y + edge.y * edge.z + edge.z * edge.x);
}

/// A node, or an object of a leaf.
struct Part {
    uint32_t number = 0;
    bool object = false;
    Box3 box;
};

/// The parts one level below; the same where there is none.
std::vector<Part> below(const InstanceOctree& octree, const Scene& scene, const std::vector<Part>& level) {
    std::vector<Part> parts;
    for (const Part& part : level) {
        if (part.object) {
            parts.push_back(part);
            continue;
        }
        const InstanceOctree::Node& node = octree.nodes()[part.number];
        if (node.leaf())
            for (const uint32_t instance : octree.instancesOf(node))
                parts.push_back({instance, true, scene.instanceBox(instance)});
        else
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child)
                parts.push_back({child, false, octree.nodes()[child].box});
        if (parts.size() > kMostBoxes) return parts;
    }
    return parts;
}

}  // namespace

std::vector<size_t> questionEnds(std::span<const double> staysHidden, size_t most) {
    std::vector<size_t> ends;
    for (size_t first = 0; first < staysHidden.size();) {
        size_t count = 1;
        double all = staysHidden[first], value = 1.0;
        while (count < most && first + count < staysHidden.size()) {
            all *= staysHidden[first + count];
            const double more = double(count + 1) / (1.0 + (1.0 - all) * double(count + 1));
            if (!(more > value)) break;
            value = more;
            ++count;
        }
        first += count;
        ends.push_back(first);
    }
    return ends;
}

std::vector<Box3> tightBoxes(const InstanceOctree& octree, const Scene& scene, uint32_t node, size_t depth, double area) {
    std::vector<Part> level{{node, false, octree.nodes()[node].box}};
    const double own = surfaceOf(level.front().box);
    for (size_t down = 0; down < depth; ++down) {
        std::vector<Part> next = below(octree, scene, level);
        double sum = 0.0;
        for (const Part& part : next) sum += surfaceOf(part.box);
        if (next.size() > kMostBoxes || !(sum <= area * own)) break;
        level = std::move(next);
    }
    std::vector<Box3> boxes;
    for (const Part& part : level) boxes.push_back(part.box);
    return boxes;
}

}  // namespace cullscope::occlusion
