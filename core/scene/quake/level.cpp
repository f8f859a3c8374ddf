#include "core/scene/quake/level.h"

namespace cullscope::quake {

uint32_t Level::leafAt(const Vec3& place) const {
    for (int32_t at = 0;;) {
        const Node& node = nodes[size_t(at)];
        const Plane& plane = planes[node.plane];
        at = node.children[glm::dot(plane.normal, place) - plane.distance >= 0.0 ? 0 : 1];
        if (at < 0) return uint32_t(-1 - at);
    }
}

bool Level::mayBeSeen(int32_t from, int32_t to) const {
    if (from < 0 || to < 0) return false;
    if (clusters == 0) return true;
    const auto byte = uint8_t(visibleBits[size_t(from) * bytesOfCluster + size_t(to) / 8]);
    return (byte >> (to % 8) & 1) != 0;
}

}  // namespace cullscope::quake
