#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/frustum.h"
#include "core/visibility/spherical_decision.h"

namespace cullscope {

/// Why something is not drawn.
enum class Cause { OutsideFrustum, BackFacing, Hidden, TooSmall };
inline constexpr size_t kCauseCount = 4;
/// English, marked for translation.
[[nodiscard]] const char* causeName(Cause cause);
/// "left plane", …: English, marked for translation.
[[nodiscard]] const char* planeName(FrustumPlane plane);

/// One decision of one `cull`.
struct TraceEvent {
    enum class Kind {
        TestedPlane,  ///< `plane` and `distance` say how the subject lies
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
    double bound = 0.0;  ///< of a plane test: outside only where distance < −bound (geometry/frustum.h, conservativeSlack)
};

/// The decisions of one `cull`, in the order they were made.
struct Trace {
    std::vector<TraceEvent> events;
    std::vector<SphericalDecision> spherical;  ///< of strategies with maps of directions: one an object
};

}  // namespace cullscope
