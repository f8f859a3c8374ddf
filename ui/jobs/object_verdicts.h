#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/visibility/triangle_states.h"
#include "ui/jobs/snapshot_reading.h"

namespace cullscope::ui {

/// What became of whole objects: against the truth where that is known, else what the strategy decided about their boxes. Worked
/// out for an object when it is first asked for, because only the rows on the screen are.
class ObjectVerdicts {
public:
    struct Verdict {
        TriangleState state = TriangleState::Visible;
        bool againstTruth = false;  ///< false: Visible means submitted

        bool operator==(const Verdict&) const = default;
    };

    /// `states` and `reading` may be null; where both are given, the states count. Both are numbered as in `scene`.
    void set(const ScenePointer& scene, const std::shared_ptr<const TriangleStates>& states,
             const SnapshotReadingPointer& reading);
    /// Of an instance of the scene. Wrongly culled, where any of its triangles is; else visible, where any is; else in vain,
    /// where any is; else the state that most of them have. None: not known.
    [[nodiscard]] std::optional<Verdict> of(uint32_t instance) const;

private:
    [[nodiscard]] TriangleState fromStates(uint32_t instance) const;

    ScenePointer m_scene;
    std::shared_ptr<const TriangleStates> m_states;
    std::shared_ptr<const StructureSnapshot> m_snapshot;
    mutable std::vector<int8_t> m_known;  ///< by instance, of the states; -1: not worked out yet
    std::vector<int64_t> m_nodes;         ///< by instance, its first node without children; -1: none
};

}  // namespace cullscope::ui
