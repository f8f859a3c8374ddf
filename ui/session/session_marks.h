#pragma once

#include <cstddef>
#include <cstdint>

#include "core/visibility/subject_shape.h"
#include "ui/jobs/picture_maker.h"
#include "ui/jobs/strategy_slot.h"

// What is marked in the views of a session: what was picked, the step in hand, a chosen group.
namespace cullscope::ui {

/// The picked triangle and point, numbered as in the whole scene, hidden objects included.
struct Pick {
    uint32_t object = 0;    ///< instance of the opened scene
    uint64_t triangle = 0;  ///< of the opened scene
    Vec3 point{0.0};

    bool operator==(const Pick&) const = default;
};

/// Where a stepped view stands in its frame's replay.
struct ShownStep {
    int view = 0;    ///< whose culling is stepped; its observers show the same
    LogPlace place;  ///< in `frame`
    size_t step = 0, count = 0;
    ViewFramePointer frame;  ///< the whole one, recorded
    SubjectShape shape;      ///< of the entry in hand

    [[nodiscard]] bool operator==(const ShownStep& other) const {
        return view == other.view && place == other.place && step == other.step && frame == other.frame;
    }
};

/// A group of what a strategy built, such as a node of its tree, that was chosen to be marked in the views that cull with it.
struct ChosenGroup {
    BuiltStrategyPointer strategy;
    uint32_t number = 0;  ///< SnapshotNode::number
    SubjectShape shape;

    [[nodiscard]] bool operator==(const ChosenGroup& other) const { return strategy == other.strategy && number == other.number; }
};

}  // namespace cullscope::ui
