#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/spherical_grid.h"

namespace cullscope::spherical {

/// The directions of the middles of a grid's cells, for loops over all cells that use products instead of trigonometry.
class CellDirections {
public:
    explicit CellDirections(const SphericalGrid& grid);

    /// (cos, sin) of the middle of a row's zenith angles and of a column's azimuths.
    [[nodiscard]] const Vec2& row(uint32_t row) const { return m_rows[row]; }
    [[nodiscard]] const Vec2& column(uint32_t column) const { return m_columns[column]; }
    /// The unit vector of a cell's middle.
    [[nodiscard]] Vec3 middle(const SphericalGrid::Cell& cell) const {
        const Vec2 &theta = m_rows[cell.row], &phi = m_columns[cell.column];
        return {theta.y * phi.x, theta.y * phi.y, theta.x};
    }

private:
    std::vector<Vec2> m_rows, m_columns;
};

/// acos(x) for x in [−1, 1] within kQuickAngleError radians: Abramowitz & Stegun 1964, 4.4.45.
[[nodiscard]] inline double quickAcos(double x) {
    const double a = std::abs(x);
    const double angle = std::sqrt(std::max(0.0, 1.0 - a)) * (1.5707288 + a * (-0.2121144 + a * (0.0742610 - 0.0187293 * a)));
    return x < 0.0 ? std::numbers::pi - angle : angle;
}

/// atan2(y, x), turned into [0, 2π], within kQuickAngleError radians: Abramowitz & Stegun 1964, 4.4.49, and symmetry.
[[nodiscard]] inline double quickAzimuth(double y, double x) {
    const double ax = std::abs(x), ay = std::abs(y);
    const double larger = std::max(ax, ay), smaller = std::min(ax, ay);
    const double t = larger > 0.0 ? smaller / larger : 0.0, s = t * t;
    double angle = t * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))));
    angle = ay > ax ? 0.5 * std::numbers::pi - angle : angle;
    angle = x < 0.0 ? std::numbers::pi - angle : angle;
    return y < 0.0 ? 2.0 * std::numbers::pi - angle : angle;
}

inline constexpr double kQuickAngleError = 7e-5;

}  // namespace cullscope::spherical
