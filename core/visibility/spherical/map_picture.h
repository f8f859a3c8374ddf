#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The quantity that a cell's colour on the index map shows.
enum class MapColouring {
    Entries,  ///< the number of triangles in the cell, logarithmic
    Radius,   ///< the largest distance of their points from the centre, relative to the bounding sphere
    State,    ///< the state of the triangles whose centroids lie in the cell
    Level,    ///< of `spherical-lossless`: the level of the quadtree at which its walk ended, relative to the deepest leaf of any
              ///< direction
    Kernel    ///< of `spherical-lossless`: the radius up to which the solid is filled in that direction, relative to the bounding
              ///< sphere
};
/// The id used in files and on the command line: "entries", "radius", "state", "level", "kernel".
[[nodiscard]] const char* mapColouringId(MapColouring colouring);
/// Throws Error(Usage) naming the known ids for any other.
[[nodiscard]] MapColouring mapColouringFromId(std::string_view id);

/// Whether a map has the data for a colouring: a quadtree for Level, a filled inner kernel for Kernel; none is needed for the
/// others.
[[nodiscard]] bool hasColouring(const MapSnapshot& map, MapColouring colouring);

/// The value of each cell, scaled to [0, 1], for every colouring but State.
struct CellShares {
    std::vector<float> shares;       ///< by cell number, in [0, 1]; below 0: the cell is empty
    double least = 0.0, most = 0.0;  ///< the values at 0 and 1: triangles, mesh units, or levels
};
/// All cells are empty where the map has no data for the colouring.
[[nodiscard]] CellShares cellShares(const MapSnapshot& map, MapColouring colouring);

/// The colour of a share from 0 to 1: a small share is near the background's lightness, a large one far from it.
[[nodiscard]] Vec3f rampColour(double share, const Vec3f& background);

/// By cell number; the background's colour where a cell is empty. State uses the verdicts' colours.
[[nodiscard]] std::vector<Vec3f> cellColours(const MapSnapshot& map, MapColouring colouring, const Vec3f& background);

/// The directions at one angle α from the axis of the bands, as points (θ, φ), φ continued over the seam: the last point is the
/// first, or differs from it by a whole turn where the curve goes around a pole.
[[nodiscard]] std::vector<Vec2> contour(const ContourBands& bands, double alpha);

/// The same, cut at the seam.
struct Contour {
    double alpha = 0.0;
    /// As lines on the map through points (θ, φ) in radians, cut where the curve goes over the seam, φ in [0, 2π].
    std::vector<std::vector<Vec2>> lines;
};
/// The borders between the bands by ascending α, without the start (α = 0) and the end (α = 180°), which are points.
[[nodiscard]] std::vector<Contour> contours(const ContourBands& bands);

/// The angles (θ, φ) of a direction of any length but 0; φ in [0, 2π).
[[nodiscard]] Vec2 mapAngles(const Vec3& direction);

/// The triangle index map as a picture of a given size, φ to the right (0 … 360°) and θ downward (0 … 180°), twice as wide as it
/// is high, with ticks every 30°. It shows the cells' colours; the visible region in dashed red, its boxes, the corner rays'
/// points (crosses for rays that missed) and, of a recorded frame, the cells that the rays walked; the contours between the bands
/// with their start (ring) and end (dot); the cells that `spherical-lossless` tested, if they are some pixels large, and in a
/// wide red line the kernel's outline as seen from the eye, with the directions to the eye (ring) and away from it (dot). RGBA,
/// rows from the bottom.
[[nodiscard]] std::vector<uint8_t> mapPicture(const MapSnapshot& map, MapColouring colouring, const Viewport& size,
                                              const DrawStyle& style);

}  // namespace cullscope::spherical
