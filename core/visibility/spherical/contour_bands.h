#pragma once

#include <memory>

#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/decision.h"
#include "core/visibility/spherical/readings.h"

namespace cullscope {
class ObjectRecord;
}

namespace cullscope::spherical {

/// The data of a mesh's maps that the band tests of `spherical` and `spherical-horizon` need, computed once.
struct BandCells {
    struct Cell {
        uint32_t number = 0;
        uint32_t row = 0, column = 0;
        float farthestCentroid = 0.0f;  ///< R of the cell's farthest centroid
    };

    explicit BandCells(const SphericalMaps& maps);
    [[nodiscard]] uint64_t bytes() const { return cells.size() * sizeof(Cell); }

    CellDirections directions;
    std::vector<Cell> cells;  ///< those that own triangles, ascending
};

/// Contour bands around the axis from the centre to the eye, with all sizes 0; `width` in radians.
[[nodiscard]] ContourBands makeBands(const Vec3& eye, double width, uint32_t sectors);

/// Area_Sampling and Hidden_Surface_Test of Han & Hong 2008, Appendix 1. S of a cell is the distance of its farthest centroid
/// from the centre, projected on the perpendicular of the axis in the direction of the cell's middle; S of a band's sector is the
/// largest of its cells. Cells within 90° of the axis are drawn. Beyond, a sector's band is drawn whose S exceeds the largest
/// S before it; with Cut::ForGood nothing is drawn from the first band on where it does not. A band across 90° is compared as one
/// beyond, but its cells within 90° are drawn (BandSector::within). Fills the bands and returns the drawn cells in
/// runs (which may include empty cells). `record`, if it is not null, is told of each sector's test where it falls, sector by
/// sector and in each from the near point on.
[[nodiscard]] std::vector<CellRun> drawnByS(const BandCells& cells, ContourBands& bands, Cut cut, ObjectRecord* record = nullptr);

/// The number in ContourBands::table of the sector to which drawnByS counts a cell whose middle has that direction.
[[nodiscard]] uint32_t sectorOfCell(const ContourBands& bands, const Vec3& middle);

/// Collects cells in ascending order into runs; between two cells of a run there may only be cells without triangles.
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
