#include "core/spatial/occupancy.h"

#include <algorithm>

namespace cullscope {

std::vector<double> occupancyValues(const Scene& scene) {
    std::vector<double> values;
    values.reserve(scene.instances().size());
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        double value = 0.0;
        if (scene.meshOf(i).triangleCount() > 0) {
            const Vec3 half = scene.meshOf(i).localBounds().halfExtent();
            for (int axis = 0; axis < 3; ++axis)
                value = std::max(value, half[axis] * glm::length(Vec3(scene.instances()[i].worldFromMesh[axis])));
        }
        values.push_back(value);
    }
    return values;
}

}  // namespace cullscope
