#include "core/visibility/spherical/cell_directions.h"

namespace cullscope::spherical {

CellDirections::CellDirections(const SphericalGrid& grid) {
    const auto arm = [](double from, double to) {
        const double middle = (from + to) / 2;
        return Vec2(std::cos(middle), std::sin(middle));
    };
    for (uint32_t row = 0; row < grid.rows(); ++row) m_rows.push_back(arm(grid.thetaOf(row), grid.thetaOf(row + 1)));
    for (uint32_t column = 0; column < grid.columns(); ++column)
        m_columns.push_back(arm(grid.phiOf(column), grid.phiOf(column + 1)));
}

}  // namespace cullscope::spherical
