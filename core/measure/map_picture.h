#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/visibility/inside.h"

namespace cullscope {

/// What a cell's colour on the index map says.
enum class MapColouring {
    Entries,  ///< how many triangles the index map has there, by the logarithm
    Radius,   ///< how far from the centre the farthest of them reaches, against the bounding sphere
    State     ///< what became of the triangles whose centroid lies there
};
/// "entries", "radius", "state": as in files and on the command line.
[[nodiscard]] const char* mapColouringId(MapColouring colouring);
/// Throws Error(Usage) for another id, naming those there are.
[[nodiscard]] MapColouring mapColouringFromId(std::string_view id);

/// A colour for a share from 0 to 1; brightness goes one way all along, and the end at 1 stands out most from the background.
[[nodiscard]] Vec3f rampColour(double share, const Vec3f& background);
/// The colours between which rampColour goes straight, at equal distances.
[[nodiscard]] std::array<Vec3f, 5> rampColours(const Vec3f& background);

/// The background for which the ramp of radii is, whatever lies behind the picture: the farther out the brighter, because light
/// makes relief only of bright colours.
inline constexpr Vec3f kRadiusRamp(0.0f);

/// By cell number; the background's where a cell is empty. States have the verdicts' colours.
[[nodiscard]] std::vector<Vec3f> cellColours(const InsideMap& map, MapColouring colouring, const Vec3f& background);

/// The directions at one angle α from the axis of the bands.
struct Contour {
    double alpha = 0.0;
    /// As lines on the map through points (θ, φ) in radians, cut where the curve goes over the seam, φ in [0, 2π].
    std::vector<std::vector<Vec2>> lines;
};
/// The borders between the bands, by growing α: all but the start (α = 0) and the end (α = 180°), which are points.
[[nodiscard]] std::vector<Contour> contours(const ContourBands& bands);

/// (θ, φ) of a direction of any length but 0; φ in [0, 2π).
[[nodiscard]] Vec2 mapAngles(const Vec3& direction);

/// The triangle index map as a picture of a size, φ to the right (0 … 360°) and θ downward (0 … 180°), twice as wide as it is
/// high, with ticks every 30°: the cells' colours; the visible region in dashed red, its boxes, the corner rays' points (crosses
/// where a ray missed) and, of a traced cull, the cells that they walked; the contours between the bands with their start (ring)
/// and end (dot). RGBA, rows from the bottom.
[[nodiscard]] std::vector<uint8_t> mapPicture(const InsideMap& map, MapColouring colouring, const Viewport& size,
                                              const DrawStyle& style);

}  // namespace cullscope
