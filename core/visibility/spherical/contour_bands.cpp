#include "core/visibility/spherical/contour_bands.h"

#include <algorithm>

#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

/// The position of a cell's middle among the bands.
struct Place {
    double alongAxis = 0.0;  ///< cos α
    double across = 0.0;     ///< sin α
    size_t entry = 0;        ///< index into the table
};

class Placing {
public:
    explicit Placing(const ContourBands& bands) : m_bands(bands) {}

    [[nodiscard]] Place of(const Vec3& direction) const {
        Place place;
        place.alongAxis = std::clamp(glm::dot(direction, m_bands.axis), -1.0, 1.0);
        place.across = std::sqrt(1.0 - place.alongAxis * place.alongAxis);
        const double beta = quickAzimuth(glm::dot(direction, m_bands.over), glm::dot(direction, m_bands.side));
        place.entry = size_t(m_bands.bandOf(quickAcos(place.alongAxis))) * m_bands.sectors + m_bands.sectorOf(beta);
        return place;
    }

private:
    const ContourBands& m_bands;
};

/// For each sector, from near to far: which bands are drawn. A band without triangles has no S and changes nothing. On entry
/// `within` says whether a sector has cells within 90°; afterwards that of those that are not drawn.
void compareWithNearer(ContourBands& bands, Cut cut, ObjectRecord* record) {
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        double largest = 0.0;
        std::optional<uint32_t> cutter;
        for (uint32_t band = 0; band < bands.bands; ++band) {
            BandSector& entry = bands.table[size_t(band) * bands.sectors + sector];
            entry.horizon = largest;
            const bool near = (band + 1) * bands.width <= std::numbers::pi / 2 * (1.0 + 1e-12);
            const bool hidden = !near && entry.size > 0.0 && entry.size <= largest;
            if (cut == Cut::ForGood && cutter) entry.cutBy = *cutter;
            if (hidden && !cutter) cutter = band;
            entry.drawn = !(hidden || entry.cutBy != BandSector::kUncut);
            entry.within = entry.within && !entry.drawn;
            if (record != nullptr) saySector(bands, band, sector, *record);
            largest = std::max(largest, entry.size);
        }
    }
}

}  // namespace

BandCells::BandCells(const SphericalMaps& maps) : directions(maps.grid()) {
    const SphericalGrid& grid = maps.grid();
    for (uint32_t number = 0; number < grid.cellCount(); ++number) {
        const std::span<const uint32_t> owned = maps.centroids(number);
        if (owned.empty()) continue;
        const auto [row, column] = grid.cell(number);
        cells.push_back({number, row, column, maps.centroidRadius(owned.back())});
    }
}

ContourBands makeBands(const Vec3& eye, double width, uint32_t sectors) {
    ContourBands bands;
    bands.axis = glm::normalize(eye);
    const Vec3 aside = std::abs(bands.axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    bands.side = glm::normalize(glm::cross(aside, bands.axis));
    bands.over = glm::cross(bands.axis, bands.side);
    bands.width = width;
    bands.bands = uint32_t(std::ceil(std::numbers::pi / width - 1e-9));
    bands.sectors = sectors;
    bands.table.resize(size_t(bands.bands) * sectors);
    return bands;
}

std::vector<CellRun> drawnByS(const BandCells& cells, ContourBands& bands, Cut cut, ObjectRecord* record) {
    const Placing placing(bands);
    std::vector<Place> places(cells.cells.size());
    for (size_t i = 0; i < places.size(); ++i) {
        const BandCells::Cell& cell = cells.cells[i];
        places[i] = placing.of(cells.directions.middle({cell.row, cell.column}));
        BandSector& entry = bands.table[places[i].entry];
        entry.size = std::max(entry.size, cell.farthestCentroid * places[i].across);
        entry.within = entry.within || places[i].alongAxis >= 0.0;
    }
    compareWithNearer(bands, cut, record);
    RunCollector runs;
    for (size_t i = 0; i < places.size(); ++i) {
        runs.add(cells.cells[i].number, places[i].alongAxis >= 0.0 || bands.table[places[i].entry].drawn);
    }
    return runs.take();
}

uint32_t sectorOfCell(const ContourBands& bands, const Vec3& middle) { return uint32_t(Placing(bands).of(middle).entry); }

}  // namespace cullscope::spherical
