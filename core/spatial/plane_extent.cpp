#include "core/spatial/plane_extent.h"

#include <algorithm>

namespace cullscope {

PlaneExtent extentOf(uint32_t polygon, const CutTriangles& triangles, const CuttingPlane& plane) {
    PlaneExtent extent;
    for (const CutTriangles::Corner& corner : triangles.cornersOf(polygon)) {
        const int side = triangles.side(corner.vertex, plane);
        extent.front = extent.front || side > 0;
        extent.back = extent.back || side < 0;
        const double distance = plane.distance(triangles.position(corner.vertex));
        // What lies in the plane reaches to no side, whatever its rounded distance says.
        if (side < 0) extent.least = std::min(extent.least, distance);
        if (side > 0) extent.most = std::max(extent.most, distance);
    }
    return extent;
}

}  // namespace cullscope
