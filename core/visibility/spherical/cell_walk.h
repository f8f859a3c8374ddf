#pragma once

#include <array>

#include "core/spatial/cell_tree.h"
#include "core/visibility/spherical/kernel_horizon.h"
#include "core/visibility/spherical/object_space_view.h"

namespace cullscope::spherical {

/// The tests that may be applied to an object's cells in one view.
struct CellTests {
    uint8_t planes = 0x3f;                   ///< bit p: FrustumPlane p may cut the object
    bool cones = false;                      ///< normal cones; only where back faces are not drawn
    const KernelHorizon* horizon = nullptr;  ///< null: no horizon test
};

/// Walks the quadtree of an object. A node that is outside one plane, completely back-facing, or hidden behind the kernel is
/// culled with its subtree; one with no undecided test is drawn without visiting its children; leaves are drawn. Conservative:
/// nothing visible in the picture is culled, its rounding and its snapping to 1/256 pixel included. `record`, if it is not null,
/// is told of the tests where they fall, and of the result for each node at which the walk ended.
[[nodiscard]] CellWalk walkCells(const CellTree& tree, const ObjectSpaceView& view, const CellTests& tests,
                                 ObjectRecord* record = nullptr);

}  // namespace cullscope::spherical
