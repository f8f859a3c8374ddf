#pragma once

#include <optional>
#include <vector>

#include "core/base/message.h"
#include "core/visibility/strategy.h"

namespace cullscope {

/// One step in the chain of decisions about a triangle.
struct WhyStep {
    Message sentence;                   ///< arguments may be marked texts, such as the name of a plane
    std::optional<FrustumPlane> plane;  ///< where a plane was tested
    std::optional<double> distance;     ///< signed, positive inside, scene units
    std::optional<double> bound;        ///< the test classifies as outside only below −bound
    Containment containment = Containment::Straddles;
};

/// The chain for one scene triangle number: the tests of `strategy` and its decision about the triangle's object according to
/// `trace`, then whether the triangle is in `list`, then how OpenGL treats it under the list's facing rule. All from one cull of
/// the culling view.
[[nodiscard]] std::vector<WhyStep> why(const Scene& scene, const View& culling, const Strategy& strategy, const DrawList& list,
                                       const Trace& trace, uint64_t triangle);

}  // namespace cullscope
