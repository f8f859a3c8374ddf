#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/triangle_states.h"
#include "ui/jobs/snapshot_reading.h"

namespace cullscope::ui {

/// The verdict on each object: against the truth if that is known, else the strategy's decision on the object's box. Computed
/// when an object's verdict is first read, because a list reads only its visible rows.
class ObjectVerdicts {
public:
    struct Verdict {
        TriangleState state = TriangleState::Visible;
        bool againstTruth = false;  ///< false: Visible means submitted

        bool operator==(const Verdict&) const = default;
    };

    /// `states` and `reading` may be null; if both are given, `states` is used. Both number instances and triangles as `scene`
    /// does.
    void set(const ScenePointer& scene, const std::shared_ptr<const TriangleStates>& states,
             const SnapshotReadingPointer& reading);
    /// The verdict on an instance of the scene: wrongly culled if any of its triangles is; else visible if any is; else drawn in
    /// vain if any is; else the state of most of its triangles. None: not known.
    [[nodiscard]] std::optional<Verdict> of(uint32_t instance) const;

private:
    [[nodiscard]] TriangleState fromStates(uint32_t instance) const;

    ScenePointer m_scene;
    std::shared_ptr<const TriangleStates> m_states;
    std::shared_ptr<const StructureSnapshot> m_snapshot;
    mutable std::vector<int8_t> m_known;  ///< by instance: its state from m_states; -1: not computed yet
    std::vector<int64_t> m_nodes;         ///< by instance: its first node without children; -1: none
};

}  // namespace cullscope::ui
