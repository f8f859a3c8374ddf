#pragma once

#include <memory>

#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// What the band tests of both spherical strategies need of a mesh's maps, worked out once.
struct BandCells {
    struct Cell {
        uint32_t number = 0;
        uint32_t row = 0, column = 0;
        float farthestCentroid = 0.0f;  ///< R of the last one: the centroid map is sorted by it
    };

    explicit BandCells(const SphericalMaps& maps);
    [[nodiscard]] uint64_t bytes() const { return cells.size() * sizeof(Cell); }

    CellDirections directions;
    std::vector<Cell> cells;  ///< those that own triangles, ascending
};

/// Contour bands around the axis from the centre to the eye, empty yet: `width` in radians, all sizes 0.
[[nodiscard]] ContourBands makeBands(const Vec3& eye, double width, uint32_t sectors);

/// Area_Sampling and Hidden_Surface_Test of Han & Hong 2008, Appendix 1. S of a cell is its farthest centroid's distance from the
/// centre, projected on the perpendicular of the axis in the direction of the cell's middle; S of a band's sector is its cells'
/// largest. Drawn is what lies within 90° of the axis, and beyond it each sector as long as its bands' S exceeds the largest S
/// nearer; there it is cut, and nothing after it is drawn. Fills the bands and gives the drawn cells in runs (over empty cells
/// too).
[[nodiscard]] std::vector<CellRun> drawnByS(const BandCells& cells, ContourBands& bands);

/// Collects cells in ascending order into runs; between two of them may only lie cells that own nothing.
class RunCollector {
public:
    void add(uint32_t cell, bool drawn) {
        if (!drawn)
            m_open = false;
        else if (m_open)
            m_runs.back().last = cell + 1;
        else
            m_runs.push_back({cell, cell + 1});
        m_open = drawn;
    }
    [[nodiscard]] std::vector<CellRun> take() { return std::move(m_runs); }

private:
    std::vector<CellRun> m_runs;
    bool m_open = false;
};

}  // namespace cullscope::spherical
