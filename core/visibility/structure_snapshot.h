#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/visibility/spherical/decision.h"
#include "core/visibility/trace.h"

namespace cullscope {

/// A box that a strategy tests as one thing: that of an object, or of a group of them.
struct SnapshotNode {
    static constexpr uint32_t kGroup = 0xFFFFFFFF;

    int32_t parent = -1;    ///< index into StructureSnapshot::nodes; -1: a root
    uint32_t instance = 0;  ///< kGroup: of no single one
    uint32_t objects = 1;   ///< how many it holds
    Box3 box;               ///< world coordinates
    uint64_t triangles = 0;
    bool culled = false;
    Cause cause = Cause::OutsideFrustum;  ///< where culled
    Containment containment = Containment::Straddles;
    std::optional<FrustumPlane> rejectedBy;  ///< where a plane culled it

    [[nodiscard]] bool isGroup() const { return instance == kGroup; }
};

/// What a strategy shows of its inside after a cull, as plain data.
struct StructureSnapshot {
    std::vector<SnapshotNode> nodes;           ///< empty: this strategy has no boxes
    std::vector<spherical::MapSnapshot> maps;  ///< by instance; empty: this strategy has no maps of directions

    /// Null: this strategy has no map of the object.
    [[nodiscard]] const spherical::MapSnapshot* mapOf(uint32_t instance) const {
        for (const spherical::MapSnapshot& map : maps)
            if (map.decision.instance == instance) return &map;
        return nullptr;
    }
};

}  // namespace cullscope
