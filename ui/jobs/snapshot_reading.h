#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/plane_distances.h"
#include "core/visibility/why.h"
#include "ui/jobs/built_strategy.h"

namespace cullscope::ui {

/// What a view's strategy decided, read out of one traced cull. Numbers are of `strategy->scene`.
struct SnapshotReading {
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport size;
    std::shared_ptr<const StructureSnapshot>
        snapshot;                      ///< never null; the same pointer as long as strategy, camera and size are the same
    size_t map = 0;                    ///< its place in `inside` where there are maps: the one that was made to be looked at
    std::optional<uint64_t> triangle;  ///< what `why` is about; none: nothing picked, or its object is hidden
    std::vector<WhyStep> why;
    std::vector<PlaneDistance> planes;  ///< of the box of the picked triangle's object, all six; none without a triangle
    Message failure;                    ///< why the strategy could not be asked, so that nothing is known; empty: it could
};

/// The place of the map that is worth looking at: of that instance; none: of the first that is not outside the frustum, else of
/// the first. There is at least one.
[[nodiscard]] size_t placeOfMap(const StructureSnapshot& snapshot, const std::optional<uint32_t>& instance);

using SnapshotReadingPointer = std::shared_ptr<const SnapshotReading>;

}  // namespace cullscope::ui
