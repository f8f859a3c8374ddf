#include "core/visibility/trace.h"

namespace cullscope {

std::vector<std::optional<FrustumPlane>> rejectingPlanes(const Trace& trace, size_t instances) {
    std::vector<std::optional<FrustumPlane>> planes(instances);
    for (const TraceEvent& event : trace.events)
        if (event.kind == TraceEvent::Kind::TestedPlane && event.containment == Containment::Outside)
            planes[event.instance] = event.plane;
    return planes;
}

}  // namespace cullscope
