#pragma once

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
    /// A range of rows and columns (which may continue over the seam) that contains all cells touched by the triangle.
    struct Window {
        uint32_t firstRow = 0, lastRow = 0;
        uint32_t firstColumn = 0, columns = 0;
    };

    [[nodiscard]] Window windowIn(const SphericalGrid& grid) const;

    std::array<Vec3, 3> m_planes{};  ///< inward normals of the arcs' planes, not of unit length; null: no bound
    double m_tolerance = 0.0;        ///< distance by which directions may lie outside a plane
    bool m_flat = false;             ///< in a plane through the origin: directions must lie in the planes, not on one side of
                                     ///< them
    Vec3 m_capAxis{0.0, 0.0, 1.0};
    double m_capCosine = -1.0;  ///< cosine of the radius of a cap around all corners; −1: none narrower than a hemisphere
};

}  // namespace cullscope
