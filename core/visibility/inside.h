#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/visibility/trace.h"

namespace cullscope {

/// A box that a strategy tests as one thing.
struct InsideNode {
    int32_t parent = -1;  ///< index into Inside::nodes; -1: a root
    uint32_t instance = 0;
    Box3 box;  ///< world coordinates
    uint64_t triangles = 0;
    bool culled = false;
    Cause cause = Cause::OutsideFrustum;  ///< where culled
    Containment containment = Containment::Straddles;
    std::optional<FrustumPlane> rejectedBy;  ///< where a plane culled it
};

/// What a strategy shows of its inside after a cull, as plain data.
struct Inside {
    std::vector<InsideNode> nodes;  ///< empty: this strategy has no boxes
};

}  // namespace cullscope
