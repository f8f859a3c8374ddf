#pragma once

#include <cstdint>

#include "core/spatial/cut_triangles.h"

namespace cullscope {

/// How far a polygon reaches to both sides of a plane.
struct PlaneExtent {
    bool front = false, back = false;  ///< whether a corner lies there, decided exactly
    double least = 0.0, most = 0.0;    ///< signed distances of its corners, in units of the scene

    [[nodiscard]] bool on(int side) const { return side > 0 ? front : back; }
    /// How far it reaches on a side.
    [[nodiscard]] double reach(int side) const { return side > 0 ? most : 0.0 - least; }
};

/// `polygon` is one of `triangles`.
[[nodiscard]] PlaneExtent extentOf(uint32_t polygon, const CutTriangles& triangles, const CuttingPlane& plane);

}  // namespace cullscope
