#include "core/visibility/object_nodes.h"

namespace cullscope {
namespace {

SnapshotNode untested(uint32_t instance, const Scene& scene) {
    SnapshotNode node;
    node.instance = instance;
    node.box = scene.instanceBox(instance);
    node.triangles = scene.meshOf(instance).triangleCount();
    node.containment = Containment::Inside;
    return node;
}

}  // namespace

StructureSnapshot objectNodes(const Trace& trace, const Scene& scene) {
    StructureSnapshot result;
    for (const TraceEvent& event : trace.events) {
        // The events of one object are consecutive.
        if (result.nodes.empty() || result.nodes.back().instance != event.instance)
            result.nodes.push_back(untested(event.instance, scene));
        SnapshotNode& node = result.nodes.back();
        switch (event.kind) {
            case TraceEvent::Kind::Culled:
                node.culled = true;
                node.cause = event.cause;
                break;
            case TraceEvent::Kind::TestedPlane:
            case TraceEvent::Kind::TestedAxes:
            case TraceEvent::Kind::AskedOpenGl:
            case TraceEvent::Kind::MeetsNear:
                if (event.containment == Containment::Inside) break;
                node.containment = event.containment;
                if (event.kind == TraceEvent::Kind::TestedPlane && event.containment == Containment::Outside)
                    node.rejectedBy = event.plane;
                break;
            case TraceEvent::Kind::PartlyDrawn:
            case TraceEvent::Kind::Accepted:
                break;
        }
    }
    return result;
}

}  // namespace cullscope
