#pragma once

#include <optional>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// Triangles that were left out one by one: the detail of a decision about a range of an object's triangles.
struct LeftOutTriangles final : DecisionDetail {
    struct Run {
        PlaceRun places;  ///< in the order FrameLog::order
        Cause cause = Cause::NoSample;
    };
    std::vector<Run> runs;  ///< ascending, disjoint

    /// How many were left out for a cause.
    [[nodiscard]] uint64_t count(Cause cause) const {
        uint64_t sum = 0;
        for (const Run& run : runs) sum += run.cause == cause ? run.places.count : 0;
        return sum;
    }
    /// Why the triangle at a place was left out; none: it is not one of them.
    [[nodiscard]] std::optional<Cause> causeAt(uint32_t place) const {
        for (const Run& run : runs)
            if (run.places.first <= place && place - run.places.first < run.places.count) return run.cause;
        return std::nullopt;
    }
};

/// Calls `told(instance, triangles)` for each such detail of a recorded frame.
template <typename Told>
void forEachLeftOut(const FrameLog& log, const Told& told) {
    for (const LoggedDetail& logged : log.details)
        if (const auto* triangles = dynamic_cast<const LeftOutTriangles*>(logged.detail.get()))
            told(log.decisions[logged.decision].subject.object, *triangles);
}

}  // namespace cullscope
