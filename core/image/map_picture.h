#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// What a cell's colour on the index map says.
enum class MapColouring {
    Entries,  ///< how many triangles the index map has there, by the logarithm
    Radius,   ///< how far from the centre the farthest of them reaches, against the bounding sphere
    State,    ///< what became of the triangles whose centroid lies there
    Level,  ///< of `spherical-lossless`: how deep in the quadtree its walk ended there, against the deepest leaf of any direction
    Kernel  ///< of the same: up to which radius the solid is filled in that direction, against the bounding sphere
};
/// "entries", "radius", "state", "level", "kernel": as in files and on the command line.
[[nodiscard]] const char* mapColouringId(MapColouring colouring);
/// Throws Error(Usage) for another id, naming those there are.
[[nodiscard]] MapColouring mapColouringFromId(std::string_view id);

/// Whether a map has what a colouring shows: a quadtree for Level, a filled inner kernel for Kernel; the others need neither.
[[nodiscard]] bool hasColouring(const spherical::MapSnapshot& map, MapColouring colouring);

/// Where each cell lies on the scale of a colouring but State.
struct CellShares {
    std::vector<float> shares;       ///< by cell number, in [0, 1]; below 0: the cell is empty
    double least = 0.0, most = 0.0;  ///< the values at 0 and 1: triangles, mesh units, or levels
};
/// Of a map that has no such colouring all cells are empty.
[[nodiscard]] CellShares cellShares(const spherical::MapSnapshot& map, MapColouring colouring);

/// A colour for a share from 0 to 1: little is near the background's lightness, much is far from it.
[[nodiscard]] Vec3f rampColour(double share, const Vec3f& background);

/// The colours of the model in spherical coordinates by R, at equal distances: the farther out the brighter, because light makes
/// relief only of bright colours.
[[nodiscard]] std::array<Vec3f, 5> reliefColours();

/// By cell number; the background's where a cell is empty. States have the verdicts' colours.
[[nodiscard]] std::vector<Vec3f> cellColours(const spherical::MapSnapshot& map, MapColouring colouring, const Vec3f& background);

/// The directions at one angle α from the axis of the bands as points (θ, φ), φ continued over the seam: the last one is the
/// first, a whole turn on where the curve goes around a pole.
[[nodiscard]] std::vector<Vec2> contour(const spherical::ContourBands& bands, double alpha);

/// The same, cut at the seam.
struct Contour {
    double alpha = 0.0;
    /// As lines on the map through points (θ, φ) in radians, cut where the curve goes over the seam, φ in [0, 2π].
    std::vector<std::vector<Vec2>> lines;
};
/// The borders between the bands, by growing α: all but the start (α = 0) and the end (α = 180°), which are points.
[[nodiscard]] std::vector<Contour> contours(const spherical::ContourBands& bands);

/// (θ, φ) of a direction of any length but 0; φ in [0, 2π).
[[nodiscard]] Vec2 mapAngles(const Vec3& direction);

/// The triangle index map as a picture of a size, φ to the right (0 … 360°) and θ downward (0 … 180°), twice as wide as it is
/// high, with ticks every 30°: the cells' colours; the visible region in dashed red, its boxes, the corner rays' points (crosses
/// where a ray missed) and, of a traced cull, the cells that they walked; the contours between the bands with their start (ring)
/// and end (dot); the
/// cells at which the walk of `spherical-lossless` ended, of those that are some pixels large, and in strong red the kernel's
/// outline as the eye sees it, with the directions to the eye (ring) and away from it (dot). RGBA, rows from the bottom.
[[nodiscard]] std::vector<uint8_t> mapPicture(const spherical::MapSnapshot& map, MapColouring colouring, const Viewport& size,
                                              const DrawStyle& style);

}  // namespace cullscope
