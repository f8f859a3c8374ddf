#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope::test {

[[nodiscard]] inline bool isPlaneTest(const Decision& decision) {
    return decision.outcome == Decision::Outcome::Open && decision.plane.has_value();
}

[[nodiscard]] inline bool says(const Decision& decision, std::string_view beginning) {
    return decision.sentence != nullptr && std::string_view(decision.sentence).starts_with(beginning);
}

/// Whether separating axes were tested: with "No single plane …" they part the subject from the frustum.
[[nodiscard]] inline bool isAxisTest(const Decision& decision) {
    return decision.outcome == Decision::Outcome::Open &&
           (says(decision, "No single plane") || says(decision, "Tested by separating axes"));
}

/// Calls `call(instance)` for the object that a decision is about, or for those of a group that was decided as a whole.
template <typename Call>
void forObjectsOf(const FrameLog& log, const Decision& decision, const Call& call) {
    if (decision.subject.kind == Subject::Kind::Object) call(decision.subject.number);
    if (decision.subject.kind == Subject::Kind::Node)
        for (const uint32_t instance : log.objectsOf(decision)) call(instance);
}

/// By instance: how many decisions have this outcome for it, its own and those of groups that hold it.
[[nodiscard]] inline std::vector<int> timesDecided(const FrameLog& log, Decision::Outcome outcome, size_t instances) {
    std::vector<int> times(instances, 0);
    for (const Decision& decision : log.decisions)
        if (decision.outcome == outcome) forObjectsOf(log, decision, [&](uint32_t instance) { ++times[instance]; });
    return times;
}

/// A group of objects that a walk visited, and what it found.
struct VisitedGroup {
    uint32_t node = 0;
    Containment containment = Containment::Straddles;  ///< unless this, its objects were decided with it
    std::optional<FrustumPlane> plane;                 ///< the one that it lies outside of
};

/// The groups that a recorded frame visited, in that order.
[[nodiscard]] inline std::vector<VisitedGroup> visitedGroups(const FrameLog& log) {
    std::vector<VisitedGroup> groups;
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Node) continue;
        if (groups.empty() || groups.back().node != decision.subject.number) groups.emplace_back().node = decision.subject.number;
        VisitedGroup& group = groups.back();
        if (decision.outcome == Decision::Outcome::Drawn) group.containment = Containment::Inside;
        if (decision.outcome == Decision::Outcome::Culled) group.containment = Containment::Outside;
        if (isPlaneTest(decision) && decision.containment == Containment::Outside) group.plane = decision.plane;
    }
    return groups;
}

}  // namespace cullscope::test
