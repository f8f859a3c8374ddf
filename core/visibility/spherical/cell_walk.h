#pragma once

#include <array>

#include "core/spatial/cell_tree.h"
#include "core/visibility/spherical/kernel_horizon.h"
#include "core/visibility/spherical/object_space_view.h"

namespace cullscope::spherical {

/// What may be tested of an object's cells in one view.
struct CellTests {
    uint8_t planes = 0x3f;                   ///< bit p: plane p (FrustumPlane) may cut the object
    bool cones = false;                      ///< normal cones: only front sides are drawn
    const KernelHorizon* horizon = nullptr;  ///< null: the kernel hides nothing
};

/// How far a picture may move a point, in mesh units a unit of distance from the eye: by its snapping to 1/256 pixel, counted
/// whole instead of half and once for x and y, and by the rounding of what OpenGL computes in float.
[[nodiscard]] double snapping(const ObjectSpaceView& view);

/// Walks the quadtree: a node outside one plane, with all triangles turned away, or hidden behind the kernel is left out with all
/// that it holds; one of which nothing is left to decide is drawn without being opened; leaves are drawn. Conservative: nothing
/// that the picture shows is left out, its rounding and its snapping to 1/256 pixel included. `traced`: says of each node where
/// the walk ended what became of it.
[[nodiscard]] CellWalk walkCells(const CellTree& tree, const ObjectSpaceView& view, const CellTests& tests, bool traced);

}  // namespace cullscope::spherical
