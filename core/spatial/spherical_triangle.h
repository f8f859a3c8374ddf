#pragma once

#include <array>
#include <optional>

#include "core/spatial/spherical_grid.h"

namespace cullscope {

/// The directions in which a triangle lies as seen from the origin: bounded by great-circle arcs. Triangles in a plane through
/// the origin, with a corner there, or around it are taken as what they are: arcs, and whole great circles.
class SphericalTriangle {
public:
    SphericalTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

    /// False only where the cell has no direction in common with the triangle. (True also for a few cells beside a corner: three
    /// half-spaces and a cap tell apart all but those.)
    [[nodiscard]] bool touches(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;

    /// Calls visit(cell) for every cell that the triangle touches.
    template <typename Visit>
    void forEachCell(const SphericalGrid& grid, const Visit& visit) const {
        const Window window = windowIn(grid);
        for (uint32_t row = window.firstRow; row <= window.lastRow; ++row)
            for (uint32_t step = 0; step < window.columns; ++step) {
                const SphericalGrid::Cell cell{row, (window.firstColumn + step) % grid.columns()};
                if (touches(grid, cell)) visit(cell);
            }
    }

private:
    /// Rows and columns (which may go over the seam) outside of which the triangle touches nothing.
    struct Window {
        uint32_t firstRow = 0, lastRow = 0;
        uint32_t firstColumn = 0, columns = 0;
    };

    [[nodiscard]] Window windowIn(const SphericalGrid& grid) const;

    std::array<Vec3, 3> m_planes{};  ///< inward normals of the arcs' planes, not of unit length; null: bounds nothing
    double m_tolerance = 0.0;        ///< by which directions may lie outside a plane
    bool m_flat = false;             ///< in a plane through the origin: a direction lies in the planes, not on a side of them
    Vec3 m_capAxis{0.0, 0.0, 1.0};
    double m_capCosine = -1.0;  ///< of the cap around all corners; −1: none narrower than a hemisphere
};

}  // namespace cullscope
