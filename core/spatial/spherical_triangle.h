#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "core/geometry/spherical_grid.h"

namespace cullscope {

/// The directions of a triangle's points from the origin, bounded by great-circle arcs. Degenerate triangles are handled exactly:
/// in a plane through the origin it is an arc; with a corner at the origin or the origin inside, up to a whole great circle.
class SphericalTriangle {
public:
    SphericalTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

    /// Whether the triangle touches the cell. Never false where they have a direction in common; true also for a few cells beside
    /// a corner, which three half-spaces and a cap cannot exclude.
    [[nodiscard]] bool touches(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;

    /// Calls visit(cell) for every cell that the triangle touches, each once, in an order that depends on the grid and the
    /// triangle alone. Returns how many cells and boxes of cells were tested: in proportion to the cells touched and the
    /// logarithm of the grid's, also for a sliver at a pole, whose cap reaches over all columns.
    template <typename Visit>
    uint64_t forEachCell(const SphericalGrid& grid, const Visit& visit) const {
        const Window window = windowIn(grid);
        const uint32_t beforeSeam = std::min(window.columns, grid.columns() - window.firstColumn);
        const uint32_t behindSeam = window.columns - beforeSeam;
        uint64_t tested = forEachCellIn(
            grid, {window.firstRow, window.lastRow, window.firstColumn, window.firstColumn + beforeSeam - 1}, visit);
        if (behindSeam > 0) tested += forEachCellIn(grid, {window.firstRow, window.lastRow, 0, behindSeam - 1}, visit);
        return tested;
    }

private:
    /// A range of rows and columns (which may continue over the seam) that contains all cells touched by the triangle.
    struct Window {
        uint32_t firstRow = 0, lastRow = 0;
        uint32_t firstColumn = 0, columns = 0;
    };

    [[nodiscard]] Window windowIn(const SphericalGrid& grid) const;
    /// False only where the triangle touches no cell of the box, which has at most half of the columns.
    [[nodiscard]] bool mayTouch(const SphericalGrid& grid, const SphericalGrid::Box& box) const;

    /// Halves the box while the triangle may touch it, down to a few cells.
    template <typename Visit>
    uint64_t forEachCellIn(const SphericalGrid& grid, const SphericalGrid::Box& box, const Visit& visit) const {
        constexpr uint32_t kFewCells = 8;
        const uint32_t rows = box.lastRow - box.firstRow + 1, columns = box.lastColumn - box.firstColumn + 1;
        if (rows * columns <= kFewCells) {
            for (uint32_t row = box.firstRow; row <= box.lastRow; ++row)
                for (uint32_t column = box.firstColumn; column <= box.lastColumn; ++column)
                    if (touches(grid, {row, column})) visit(SphericalGrid::Cell{row, column});
            return rows * columns;
        }
        if (2 * columns <= grid.columns() && !mayTouch(grid, box)) return 1;
        SphericalGrid::Box first = box, second = box;
        if (columns > rows) {
            first.lastColumn = box.firstColumn + columns / 2 - 1;
            second.firstColumn = first.lastColumn + 1;
        } else {
            first.lastRow = box.firstRow + rows / 2 - 1;
            second.firstRow = first.lastRow + 1;
        }
        return 1 + forEachCellIn(grid, first, visit) + forEachCellIn(grid, second, visit);
    }

    std::array<Vec3, 3> m_planes{};  ///< inward normals of the arcs' planes, not of unit length; null: no bound
    double m_tolerance = 0.0;        ///< distance by which directions may lie outside a plane
    bool m_flat = false;             ///< in a plane through the origin: directions must lie in the planes, not on one side of
                                     ///< them
    Vec3 m_capAxis{0.0, 0.0, 1.0};
    double m_capCosine = -1.0;  ///< cosine of the radius of a cap around all corners; −1: none narrower than a hemisphere
};

}  // namespace cullscope
