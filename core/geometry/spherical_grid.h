#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope {

/// A point in the spherical coordinates of Han & Hong 2008, eq. (1), computed with atan2 where the paper writes quotients.
struct SphericalPoint {
    double radius = 0.0;
    double theta = 0.0;  ///< zenith angle from +z, radians in [0, π]
    double phi = 0.0;    ///< azimuth from +x towards +y, radians in [0, 2π)
};

/// The spherical coordinates of a position; the origin has both angles 0.
[[nodiscard]] SphericalPoint sphericalPoint(const Vec3& position);
/// The angles (θ, φ) of a direction of any length but 0; φ in [0, 2π).
[[nodiscard]] inline Vec2 mapAngles(const Vec3& direction) {
    const SphericalPoint point = sphericalPoint(direction);
    return {point.theta, point.phi};
}

/// All directions from a point, divided into rows of zenith angle (row 0 at the pole +z) and columns of azimuth (column 0 from
/// +x, the last one ends at the seam): the paper's θ–φ map. Rows and columns have equal angles, so that cells near the poles are
/// small.
class SphericalGrid {
public:
    struct Cell {
        uint32_t row = 0;
        uint32_t column = 0;

        bool operator==(const Cell&) const = default;
    };

    /// A rectangle of cells, all bounds inclusive; it never crosses the seam.
    struct Box {
        uint32_t firstRow = 0, lastRow = 0;
        uint32_t firstColumn = 0, lastColumn = 0;

        bool operator==(const Box&) const = default;
    };

    /// The paper's resolution.
    static constexpr uint32_t kColumns = 360;
    static constexpr uint32_t kRows = 180;
    /// At least 4 columns and 2 rows.
    explicit SphericalGrid(uint32_t columns = kColumns, uint32_t rows = kRows);
    /// A grid with the paper's number of cells for each triangle of its bunny, for any number of triangles.
    [[nodiscard]] static SphericalGrid forTriangles(size_t triangles);

    [[nodiscard]] uint32_t columns() const { return m_columns; }
    [[nodiscard]] uint32_t rows() const { return m_rows; }
    [[nodiscard]] uint32_t cellCount() const { return m_columns * m_rows; }
    /// The number of a cell: rows from the top, columns from the left.
    [[nodiscard]] uint32_t number(const Cell& cell) const { return cell.row * m_columns + cell.column; }
    [[nodiscard]] Cell cell(uint32_t number) const { return {number / m_columns, number % m_columns}; }

    /// The cell that contains a direction of any length; for the null vector the first cell.
    [[nodiscard]] Cell cellOf(const Vec3& direction) const;
    [[nodiscard]] uint32_t rowOf(double theta) const;
    [[nodiscard]] uint32_t columnOf(double phi) const;
    /// The angle at which a row or column begins, in radians; for the number one past the last, the end of the last.
    [[nodiscard]] double thetaOf(uint32_t row) const;
    [[nodiscard]] double phiOf(uint32_t column) const;
    /// (cos, sin) of these angles.
    [[nodiscard]] const Vec2& thetaArm(uint32_t row) const { return m_thetaArms[row]; }
    [[nodiscard]] const Vec2& phiArm(uint32_t column) const { return m_phiArms[column]; }

    /// The largest normal · direction over all unit directions of a cell.
    [[nodiscard]] double largestDot(const Vec3& normal, const Cell& cell) const;
    /// The same over all cells of a box that has at most half of the columns.
    [[nodiscard]] double largestDot(const Vec3& normal, const Box& box) const;

private:
    uint32_t m_columns, m_rows;
    std::vector<Vec2> m_thetaArms, m_phiArms;  ///< one element more than rows and columns
};

}  // namespace cullscope
