#include "core/spatial/direction_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/geometry/angle.h"
#include "core/geometry/spherical_grid.h"
#include "core/geometry/triangle.h"

namespace cullscope {
namespace {

double withSign(double magnitude, double sign) { return sign < 0.0 ? -magnitude : magnitude; }

Vec3 octahedralDirection(const Vec2& point) {
    const Vec2 p = 2.0 * point - 1.0;
    Vec3 direction(p.x, p.y, 1.0 - std::abs(p.x) - std::abs(p.y));
    if (direction.z < 0.0) {
        direction.x = withSign(1.0 - std::abs(p.y), p.x);
        direction.y = withSign(1.0 - std::abs(p.x), p.y);
    }
    return glm::normalize(direction);
}

/// Spreads the bits 0b…dcba to 0b…0d0c0b0a.
uint32_t spread(uint32_t bits) {
    bits &= 0xffffU;
    bits = (bits | (bits << 8)) & 0x00ff00ffU;
    bits = (bits | (bits << 4)) & 0x0f0f0f0fU;
    bits = (bits | (bits << 2)) & 0x33333333U;
    return (bits | (bits << 1)) & 0x55555555U;
}

uint32_t gathered(uint32_t bits) {
    bits &= 0x55555555U;
    bits = (bits | (bits >> 1)) & 0x33333333U;
    bits = (bits | (bits >> 2)) & 0x0f0f0f0fU;
    bits = (bits | (bits >> 4)) & 0x00ff00ffU;
    return (bits | (bits >> 8)) & 0xffffU;
}

}  // namespace

const char* mapLayoutId(MapLayout layout) { return layout == MapLayout::Octahedral ? "octahedral" : "latitude-longitude"; }

MapLayout mapLayoutFromId(std::string_view id) {
    for (const MapLayout layout : {MapLayout::LatitudeLongitude, MapLayout::Octahedral})
        if (id == mapLayoutId(layout)) return layout;
    throwUsage(CULLSCOPE_TR("There is no layout of the map \"%1\". Known: %2."),
               {std::string(id), "latitude-longitude, octahedral"});
}

Vec3 directionAt(MapLayout layout, const Vec2& point) {
    if (layout == MapLayout::Octahedral) return octahedralDirection(point);
    const double phi = point.x * kTurn, theta = std::min(point.y * kTurn, std::numbers::pi);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

MapCell mapCellOf(MapLayout layout, const Vec3& direction, uint32_t level) {
    if (layout == MapLayout::Octahedral) return octahedralCell(direction, level);
    const SphericalPoint point = sphericalPoint(direction);
    const uint32_t size = 1U << level;
    const auto place = [&](double angle, uint32_t end) { return std::min(uint32_t(angle / kTurn * size), end - 1); };
    // The south pole belongs to the last row of the map's half of the square.
    return {level, place(point.phi, size), place(point.theta, std::max(size / 2, 1U))};
}

uint32_t mortonCode(uint32_t x, uint32_t y) { return spread(x) | (spread(y) << 1); }

MapCell mapCell(uint32_t code, uint32_t level) { return {level, gathered(code), gathered(code >> 1)}; }

double solidAngle(MapLayout layout, const MapCell& cell) {
    const double size = 1.0 / double(1U << cell.level);
    const Vec2 low(cell.x * size, cell.y * size), high = low + size;
    if (layout == MapLayout::LatitudeLongitude) {
        const double top = std::min(low.y * kTurn, std::numbers::pi), bottom = std::min(high.y * kTurn, std::numbers::pi);
        return kTurn * size * (std::cos(top) - std::cos(bottom));
    }
    // The edges of cells are great-circle arcs, except across the folds, which cells of level 1 and more only touch.
    if (cell.level == 0) return 2.0 * kTurn;
    const Vec3 a = octahedralDirection(low), b = octahedralDirection({high.x, low.y});
    const Vec3 c = octahedralDirection(high), d = octahedralDirection({low.x, high.y});
    // The diagonal along which a cell on the fold is folded: x and y grow together on it, or in opposite directions.
    const bool falling = (low.x < 0.5) == (low.y < 0.5);
    const auto angle = [](const Vec3& p, const Vec3& q, const Vec3& r) { return std::abs(solidAngle({p, q, r})); };
    return falling ? angle(a, b, d) + angle(b, c, d) : angle(a, b, c) + angle(a, c, d);
}

}  // namespace cullscope
