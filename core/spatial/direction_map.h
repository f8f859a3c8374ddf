#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "core/geometry/types.h"

namespace cullscope {

/// The projection of all directions from a point to the unit square.
enum class MapLayout {
    /// x = φ / 2π, y = θ / 2π: the upper half of the square. All cells of a row have the same solid angle; those at the poles are
    /// slivers.
    LatitudeLongitude,
    /// The unfolded faces of an octahedron (Meyer et al. 2010): the whole square, +z in its middle, −z at its four corners. No
    /// poles and no trigonometry; the solid angles of cells differ by a factor of at most 5.2.
    Octahedral
};
/// The id used for parameters and in files: "latitude-longitude", "octahedral".
[[nodiscard]] const char* mapLayoutId(MapLayout layout);
[[nodiscard]] MapLayout mapLayoutFromId(std::string_view id);

/// A cell of the square, which a level divides into 2^level × 2^level cells.
struct MapCell {
    uint32_t level = 0;
    uint32_t x = 0, y = 0;

    bool operator==(const MapCell&) const = default;
};

/// The finest level: its cells have codes of at most 32 bits.
inline constexpr uint32_t kFinestLevel = 15;

/// The unit direction at a point of the square.
[[nodiscard]] Vec3 directionAt(MapLayout layout, const Vec2& point);

/// The cell of a level that contains a direction, on the octahedral map.
[[nodiscard]] inline MapCell octahedralCell(const Vec3& direction, uint32_t level) {
    const double ax = std::abs(direction.x), ay = std::abs(direction.y), az = std::abs(direction.z);
    const double share = 1.0 / (ax + ay + az);
    double x = direction.x * share, y = direction.y * share;
    // The lower faces are folded outward over the diagonals of the square.
    if (direction.z < 0.0) {
        x = std::copysign(1.0 - ay * share, direction.x);
        y = std::copysign(1.0 - ax * share, direction.y);
    }
    const double half = 0.5 * double(1U << level);
    const uint32_t last = (1U << level) - 1;
    return {level, std::min(uint32_t(std::max(half + half * x, 0.0)), last),
            std::min(uint32_t(std::max(half + half * y, 0.0)), last)};
}
/// The cell of a level that contains a direction.
[[nodiscard]] MapCell mapCellOf(MapLayout layout, const Vec3& direction, uint32_t level);

/// The Morton code (Morton 1966): the bits of x and y interleaved, so that the cells inside a larger one have consecutive codes.
[[nodiscard]] uint32_t mortonCode(uint32_t x, uint32_t y);
[[nodiscard]] MapCell mapCell(uint32_t code, uint32_t level);

/// The solid angle of a cell, steradians; 0 for one outside the map.
[[nodiscard]] double solidAngle(MapLayout layout, const MapCell& cell);

}  // namespace cullscope
