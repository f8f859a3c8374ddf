#include "core/visibility/trace.h"

namespace cullscope {

std::vector<std::optional<FrustumPlane>> rejectingPlanes(const Trace& trace, size_t instances) {
    std::vector<std::optional<FrustumPlane>> planes(instances);
    for (const TraceEvent& event : trace.events)
        if (event.kind == TraceEvent::Kind::TestedPlane && event.containment == Containment::Outside)
            planes[event.instance] = event.plane;
    return planes;
}

void addPlaneTest(Trace& trace, uint32_t instance, FrustumPlane plane, double inner, double outer, double bound) {
    const Containment containment = inner < -bound  ? Containment::Outside
                                    : outer > bound ? Containment::Inside
                                                    : Containment::Straddles;
    trace.events.push_back({TraceEvent::Kind::TestedPlane, instance, plane, containment, inner, Cause::OutsideFrustum, bound});
}

}  // namespace cullscope
