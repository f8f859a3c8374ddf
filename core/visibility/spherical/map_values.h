#pragma once

#include "core/frame/cell_map.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The quantity that a cell's colour on the index map shows.
enum class MapQuantity {
    Entries,  ///< the number of triangles in the cell, logarithmic
    Radius,   ///< the largest distance of their points from the centre, relative to the bounding sphere
    State,    ///< the state of the triangles whose centroids lie in the cell
    Level,    ///< of `spherical-lossless`: the level of the quadtree at which its walk ended, relative to the deepest leaf of any
              ///< direction
    Kernel    ///< of `spherical-lossless`: the radius up to which the solid is filled in that direction, relative to the bounding
              ///< sphere
};
/// The id of its colouring: "entries", "radius", "state", "level", "kernel".
[[nodiscard]] const char* mapQuantityId(MapQuantity quantity);
/// Throws Error(Usage) naming the known ids for any other.
[[nodiscard]] MapQuantity mapQuantityFromId(std::string_view id);

/// Whether a map has the data for a quantity: a quadtree for Level, a filled inner kernel for Kernel; none is needed for the
/// others.
[[nodiscard]] bool hasQuantity(const MapSnapshot& map, MapQuantity quantity);
/// The values of the cells, for every quantity but State. All cells are empty where the map has no data for it.
[[nodiscard]] MapValues cellValues(const MapSnapshot& map, MapQuantity quantity);
/// Of a map with a quadtree: the state of the quadtree's cell in the direction of a display cell that holds no centroid. Display
/// cells may be smaller than the quadtree's.
[[nodiscard]] std::optional<TriangleState> stateBetweenCentroids(const MapSnapshot& map, const Vec3& direction);

}  // namespace cullscope::spherical
