#include "core/visibility/frustum/rejected_objects.h"

#include "core/base/message.h"
#include "core/visibility/object_nodes.h"

namespace cullscope::frustum {

Show rejectedObjectsShow() { return barsShow("rejected-objects", CULLSCOPE_TR("Objects by the plane that rejected them")); }

Bars rejectedObjects(const FrameLog& log, const Scene& scene, bool axes) {
    Bars counts;
    for (size_t plane = 0; plane < kFrustumPlaneCount; ++plane) counts.bars.push_back({planeName(FrustumPlane(plane)), 0});
    if (axes) counts.bars.push_back({CULLSCOPE_TR("no single plane"), 0});
    for (const SnapshotNode& object : objectNodes(log, scene).nodes)
        if (object.culled) ++counts.bars[object.rejectedBy ? size_t(*object.rejectedBy) : kFrustumPlaneCount].value;
    return counts;
}

}  // namespace cullscope::frustum
