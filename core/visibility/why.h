#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/visibility/built_strategy.h"

namespace cullscope {

/// One step in the chain of decisions about a triangle.
struct WhyStep {
    Message sentence;                   ///< arguments may be marked texts, such as the name of a plane
    std::optional<FrustumPlane> plane;  ///< where a plane was tested
    std::optional<double> distance;     ///< signed, positive inside, scene units
    std::optional<double> bound;        ///< the test classifies as outside only below −bound
    Containment containment = Containment::Straddles;
    bool ofGroup = false;  ///< a test of a group of several objects, and not of the object alone
    bool ofEnd = false;    ///< what became of the triangle, after all tests
};

/// A decision as it was said, with its numbers.
[[nodiscard]] WhyStep whyStep(const Decision& decision);

/// The chain for one scene triangle number: the decisions of a recorded frame of `strategy` about the groups that the triangle's
/// object lies in, about the object and about the triangle's cell, with their numbers; then whether the triangle was drawn, and
/// how OpenGL treats it under the frame's facing rule. Only what was tested.
[[nodiscard]] std::vector<WhyStep> why(const BuiltStrategy& strategy, const FrameLog& log, uint64_t triangle);

/// The step of a chain that decided: of a triangle that was left out the last one that it did not pass, of one that was drawn the
/// last test. What is said at the end counts only where nothing else was. Null: nothing was said.
[[nodiscard]] const WhyStep* decidingStep(std::span<const WhyStep> steps);

}  // namespace cullscope
