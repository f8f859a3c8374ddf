#include "core/spatial/spherical_triangle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cullscope {

namespace {

// For unit corners, whose cross products and determinants are exact to a few units in the last place.
constexpr double kTolerance = 1e-14;
// For a triangle that is nearly a diameter of the sphere: its inner points are scaled up much more than its corners, and their
// rounding with them.
constexpr double kLooseTolerance = 1e-7;
constexpr double kNarrowCapCosine = 0.1;

Vec3 unitOrNull(const Vec3& v) {
    const double length = std::hypot(std::hypot(v.x, v.y), v.z);
    return length > 0.0 ? v / length : Vec3(0.0);
}

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::array corners{unitOrNull(a), unitOrNull(b), unitOrNull(c)};
    for (size_t i = 0; i < 3; ++i) m_planes[i] = glm::cross(corners[i], corners[(i + 1) % 3]);
    const double volume = glm::dot(m_planes[0], corners[2]);
    m_flat = std::abs(volume) <= kTolerance;
    if (volume < 0.0)
        for (Vec3& plane : m_planes) plane = -plane;
    m_capAxis = unitOrNull(corners[0] + corners[1] + corners[2]);
    m_capCosine = 1.0;
    for (const Vec3& corner : corners)
        if (corner != Vec3(0.0)) m_capCosine = std::min(m_capCosine, glm::dot(m_capAxis, corner) - kTolerance);
    m_tolerance = m_capCosine > kNarrowCapCosine ? kTolerance / kNarrowCapCosine : kLooseTolerance;
    // For a triangle beyond a hemisphere the corners give no bound on its directions.
    if (m_capCosine <= kLooseTolerance) m_capCosine = -1.0;
}

bool SphericalTriangle::touches(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const {
    for (const Vec3& plane : m_planes) {
        if (grid.largestDot(plane, cell) < -m_tolerance) return false;
        if (m_flat && grid.largestDot(-plane, cell) < -m_tolerance) return false;
    }
    return m_capCosine < 0.0 || grid.largestDot(m_capAxis, cell) >= m_capCosine;
}

bool SphericalTriangle::mayTouch(const SphericalGrid& grid, const SphericalGrid::Box& box) const {
    // The largest product over a box is at least that over each of its cells, but for the rounding of a few units.
    constexpr double kRounding = 1e-14;
    const double least = -m_tolerance - kRounding;
    for (const Vec3& plane : m_planes) {
        if (grid.largestDot(plane, box) < least) return false;
        if (m_flat && grid.largestDot(-plane, box) < least) return false;
    }
    return m_capCosine < 0.0 || grid.largestDot(m_capAxis, box) >= m_capCosine - kRounding;
}

SphericalTriangle::Window SphericalTriangle::windowIn(const SphericalGrid& grid) const {
    if (m_capCosine < 0.0) return {0, grid.rows() - 1, 0, grid.columns()};
    constexpr double kWiden = 1e-9;  // radians: more than the error of the arc cosine of a small cap
    const SphericalPoint middle = sphericalPoint(m_capAxis);
    // acos(1 − x) loses half of its digits at small angles.
    const double reach = std::acos(std::min(1.0, m_capCosine)) + kWiden + 2e-8;
    const double top = middle.theta - reach, bottom = middle.theta + reach;
    Window window{grid.rowOf(std::max(0.0, top)), grid.rowOf(std::min(bottom, std::numbers::pi)), 0, grid.columns()};
    if (top <= 0.0 || bottom >= std::numbers::pi) return window;
    // The meridians tangent to a cap that does not contain a pole: sin Δφ = sin reach / sin θ.
    const double aside = std::asin(std::min(1.0, std::sin(reach) / std::sin(middle.theta))) + kWiden;
    const double width = 2.0 * std::numbers::pi / grid.columns();
    const double first = std::floor((middle.phi - aside) / width), last = std::floor((middle.phi + aside) / width);
    const double count = last - first + 1.0;
    if (count >= grid.columns()) return window;
    window.columns = uint32_t(count);
    window.firstColumn = uint32_t(first < 0.0 ? first + grid.columns() : first) % grid.columns();
    return window;
}

}  // namespace cullscope
