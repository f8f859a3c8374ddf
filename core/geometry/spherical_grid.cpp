#include "core/geometry/spherical_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/geometry/angle.h"

namespace cullscope {

namespace {

// With 144,046 triangles this gives the paper's 360 × 180 cells.
constexpr double kTrianglesPerSquaredRow = 144'046.0 / (180.0 * 180.0);
constexpr double kFewestRows = 8.0;
constexpr double kMostRows = 8192.0;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The largest vector · e over the unit vectors e from `from` counter-clockwise to `to`, which are at most half a turn apart.
double largestDotOverArc(const Vec2& vector, const Vec2& from, const Vec2& to) {
    if (cross(from, vector) >= 0.0 && cross(vector, to) >= 0.0) return glm::length(vector);
    return std::max(glm::dot(vector, from), glm::dot(vector, to));
}

}  // namespace

SphericalPoint sphericalPoint(const Vec3& position) {
    SphericalPoint point;
    const double aside = std::hypot(position.x, position.y);
    point.radius = std::hypot(aside, position.z);
    point.theta = std::atan2(aside, position.z);
    point.phi = std::atan2(position.y, position.x);
    if (point.phi < 0.0) point.phi += 2.0 * kPi;
    // A tiny negative angle is rounded to a whole turn, which is the first column.
    if (point.phi >= 2.0 * kPi) point.phi = 0.0;
    return point;
}

SphericalGrid::SphericalGrid(uint32_t columns, uint32_t rows) : m_columns(columns), m_rows(rows) {
    assert(columns >= 4 && rows >= 2);
    for (uint32_t row = 0; row <= rows; ++row) m_thetaArms.emplace_back(std::cos(thetaOf(row)), std::sin(thetaOf(row)));
    for (uint32_t column = 0; column <= columns; ++column)
        m_phiArms.emplace_back(std::cos(phiOf(column)), std::sin(phiOf(column)));
    // The poles are set exactly.
    m_thetaArms.front() = {1.0, 0.0};
    m_thetaArms.back() = {-1.0, 0.0};
    m_phiArms.back() = m_phiArms.front();
}

SphericalGrid SphericalGrid::forTriangles(size_t triangles) {
    const double rows = std::clamp(std::round(std::sqrt(double(triangles) / kTrianglesPerSquaredRow)), kFewestRows, kMostRows);
    return SphericalGrid(2 * uint32_t(rows), uint32_t(rows));
}

double SphericalGrid::thetaOf(uint32_t row) const { return kPi * row / m_rows; }

double SphericalGrid::phiOf(uint32_t column) const { return 2.0 * kPi * column / m_columns; }

uint32_t SphericalGrid::rowOf(double theta) const { return std::min(m_rows - 1, uint32_t(std::max(0.0, theta / kPi * m_rows))); }

uint32_t SphericalGrid::columnOf(double phi) const {
    return std::min(m_columns - 1, uint32_t(std::max(0.0, phi / (2.0 * kPi) * m_columns)));
}

SphericalGrid::Cell SphericalGrid::cellOf(const Vec3& direction) const {
    const SphericalPoint point = sphericalPoint(direction);
    return {rowOf(point.theta), columnOf(point.phi)};
}

double SphericalGrid::largestDot(const Vec3& normal, const Cell& cell) const {
    return largestDot(normal, {cell.row, cell.row, cell.column, cell.column});
}

double SphericalGrid::largestDot(const Vec3& normal, const Box& box) const {
    assert(2 * (box.lastColumn - box.firstColumn + 1) <= m_columns);
    // normal · direction = nz·cos θ + sin θ·(nx·cos φ + ny·sin φ), and sin θ is never negative: so φ is maximised first, then θ.
    const double aside = largestDotOverArc(Vec2(normal.x, normal.y), m_phiArms[box.firstColumn], m_phiArms[box.lastColumn + 1]);
    return largestDotOverArc(Vec2(normal.z, aside), m_thetaArms[box.firstRow], m_thetaArms[box.lastRow + 1]);
}

}  // namespace cullscope
