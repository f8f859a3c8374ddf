#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frame/cause.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope {

/// One decision of one `cull`.
struct TraceEvent {
    enum class Kind {
        TestedPlane,  ///< `plane` and `distance` say how the subject lies
        TestedAxes,   ///< no plane has the subject outside, but an axis parts it from the frustum (geometry/separation.h)
        MeetsNear,    ///< a point of the subject's grown box lies on the near rectangle: visible without asking
        AskedOpenGl,  ///< OpenGL was asked about the subject's grown box: `containment` is Outside where it was not hit
        Culled,       ///< `cause` says why; ends the subject
        PartlyDrawn,  ///< `cause` says why the rest is not; ends the subject
        Accepted      ///< drawn; ends the subject
    };
    Kind kind = Kind::Accepted;
    uint32_t instance = 0;
    FrustumPlane plane = FrustumPlane::Left;
    Containment containment = Containment::Inside;
    double distance = 0.0;  ///< signed, of the bounds' point farthest inside (p-vertex) from the plane, scene units
    Cause cause = Cause::OutsideFrustum;
    /// Of a plane or axis test: outside only beyond it (geometry/frustum.h, conservativeMargin); of a question to OpenGL: how far
    /// the box was grown on every side. Scene units.
    double bound = 0.0;
};

/// What became of one node of a hierarchy over instances that a `cull` visited.
struct TestedGroup {
    uint32_t node = 0;  ///< of the strategy's InstanceOctree
    Containment containment = Containment::Straddles;
    std::optional<FrustumPlane> plane{};  ///< where outside: the plane that it lies outside of; none: an axis parts them
    double distance = 0.0;                ///< where outside a plane: signed, of the box's p-vertex, scene units
    double bound = 0.0;                   ///< where outside: said only because distance < −bound
    bool wholly = false;                  ///< all its objects were decided with it, and nothing below it was visited
};

/// Triangles of one object that are left out for one cause: places in the draw list's order.
struct CulledRun {
    uint32_t instance = 0;
    spherical::PlaceRun places;
    Cause cause = Cause::OutsideFrustum;
};

/// The decisions of one `cull`, in the order they were made.
struct Trace {
    std::vector<TraceEvent> events;
    std::vector<TestedGroup> groups;    ///< of strategies with a hierarchy over instances: parents before their children
    std::vector<CulledRun> culledRuns;  ///< of strategies that leave out parts of objects for more than one cause
    std::vector<spherical::SphericalDecision> spherical;  ///< of strategies with maps of directions: one an object
};

/// By instance: the last plane that a trace names as having rejected it.
[[nodiscard]] std::vector<std::optional<FrustumPlane>> rejectingPlanes(const Trace& trace, size_t instances);

/// Writes how a subject's bounds lie to a plane as an event: `inner` and `outer` are the signed distances of their points
/// farthest inside and farthest outside. Outside and inside are said only beyond the bound.
void addPlaneTest(Trace& trace, uint32_t instance, FrustumPlane plane, double inner, double outer, double bound);

}  // namespace cullscope
