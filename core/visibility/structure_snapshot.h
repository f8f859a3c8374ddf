#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope {

/// A box that a strategy tests: that of an object, or of a group of objects.
struct SnapshotNode {
    static constexpr uint32_t kGroup = 0xFFFFFFFF;

    int32_t parent = -1;    ///< index into StructureSnapshot::nodes; -1: a root
    uint32_t instance = 0;  ///< kGroup: a group
    uint32_t number = 0;    ///< of a group: its number in the structure, as decisions have it
    uint32_t objects = 1;   ///< number of objects in it
    Box3 box;               ///< world coordinates
    uint64_t triangles = 0;
    bool culled = false;
    Cause cause = Cause::OutsideFrustum;  ///< with `culled`
    Containment containment = Containment::Straddles;
    std::optional<FrustumPlane> rejectedBy;  ///< the plane that culled it; none: no single plane did

    [[nodiscard]] bool isGroup() const { return instance == kGroup; }
};

/// A strategy's structures and their results after a cull, as plain data, for display.
struct StructureSnapshot {
    std::vector<SnapshotNode> nodes;           ///< empty: this strategy has no boxes
    std::vector<spherical::MapSnapshot> maps;  ///< by instance; empty: this strategy has no maps of directions

    /// The map of an object; null where the strategy has none.
    [[nodiscard]] const spherical::MapSnapshot* mapOf(uint32_t instance) const {
        for (const spherical::MapSnapshot& map : maps)
            if (map.decision.instance == instance) return &map;
        return nullptr;
    }
};

}  // namespace cullscope
