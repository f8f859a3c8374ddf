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
        TestedPlane,  ///< `plane` and `distance` give the result of a plane test
        TestedAxes,   ///< outside no plane, but separated from the frustum by an axis (geometry/separation.h)
        MeetsNear,    ///< a point of the grown box lies on the near rectangle: visible without an OpenGL test
        AskedOpenGl,  ///< OpenGL tested the grown box: `containment` is Outside where it was not hit
        Culled,       ///< `cause` says why; the subject's last event
        PartlyDrawn,  ///< `cause` says why the rest is not drawn; the subject's last event
        Accepted      ///< drawn; the subject's last event
    };
    Kind kind = Kind::Accepted;
    uint32_t instance = 0;
    FrustumPlane plane = FrustumPlane::Left;
    Containment containment = Containment::Inside;
    double distance = 0.0;  ///< signed, of the bounds' point farthest inside (p-vertex) from the plane, scene units
    Cause cause = Cause::OutsideFrustum;
    /// For a plane or axis test: outside only by more than this (geometry/frustum.h, conservativeMargin); for an OpenGL test: the
    /// length by which the box was grown on every side. Scene units.
    double bound = 0.0;
};

/// The result for one node of a hierarchy over instances that a `cull` visited.
struct TestedGroup {
    uint32_t node = 0;  ///< node number in the strategy's InstanceOctree
    Containment containment = Containment::Straddles;
    std::optional<FrustumPlane> plane{};  ///< with Outside: the plane it lies outside of; none: a separating axis culled it
    double distance = 0.0;                ///< with `plane`: signed distance of the box's p-vertex, scene units
    double bound = 0.0;                   ///< with Outside: the margin; distance < −bound
    bool wholly = false;                  ///< the decision holds for all its objects, and no node below it was visited
};

/// Triangles of one object that are culled for one cause, as places in the draw list's order.
struct CulledRun {
    uint32_t instance = 0;
    spherical::PlaceRun places;
    Cause cause = Cause::OutsideFrustum;
};

/// The decisions of one `cull`, in the order they were made.
struct Trace {
    std::vector<TraceEvent> events;
    std::vector<TestedGroup> groups;    ///< of strategies with a hierarchy over instances: parents before their children
    std::vector<CulledRun> culledRuns;  ///< of strategies that cull parts of objects for more than one cause
    std::vector<spherical::SphericalDecision> spherical;  ///< of strategies with maps of directions: one for each object
};

/// The last plane that a trace names as having rejected an instance, by instance.
[[nodiscard]] std::vector<std::optional<FrustumPlane>> rejectingPlanes(const Trace& trace, size_t instances);

/// Adds a plane test to a trace: `inner` and `outer` are the signed distances of the bounds' points farthest inside and farthest
/// outside. The result is Outside or Inside only where these exceed the bound.
void addPlaneTest(Trace& trace, uint32_t instance, FrustumPlane plane, double inner, double outer, double bound);

}  // namespace cullscope
