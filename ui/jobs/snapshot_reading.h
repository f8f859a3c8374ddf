#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/frame/cell_map.h"
#include "core/visibility/plane_distances.h"
#include "core/visibility/triangle_states.h"
#include "core/visibility/why.h"
#include "ui/jobs/view_frames.h"

namespace cullscope::ui {

/// The decisions of a view's strategy, read from the frame that its picture replays. Instances and triangles are
/// numbered as in the strategy's scene.
struct SnapshotReading {
    BuiltStrategyPointer strategy;
    Camera culling;
    ViewFramePointer frame;        ///< what was read; null: the frame failed
    std::optional<LogPlace> upTo;  ///< where a replay of the frame stops, with which `frame` ends; none: it is whole
    Viewport size;
    /// Never null; the pointer stays the same while strategy, camera and size do.
    std::shared_ptr<const StructureSnapshot> snapshot;
    CellMapPointer map;  ///< of the picked object, or of the one that the strategy shows by itself; null: there is none
    std::optional<uint64_t> triangle;  ///< the triangle that `why` explains; none: no triangle is picked, or its object is hidden
    std::vector<WhyStep> why;
    std::optional<TriangleState> stepState;     ///< at a step: of `triangle`, as the frame has it so far
    std::optional<ListingState> listing;        ///< of the frame; none: the strategy has no listing
    std::optional<ListingState> pickedListing;  ///< of `triangle`
    std::vector<Bars> bars;                     ///< of the frame
    std::vector<PlaneDistance> planes;          ///< of the picked object's box to all six planes; empty without a triangle
    Message failure;                            ///< why the frame failed, so that all else is unknown; empty: it succeeded
};

using SnapshotReadingPointer = std::shared_ptr<const SnapshotReading>;

}  // namespace cullscope::ui
