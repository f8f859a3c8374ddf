#include "core/visibility/spherical/slope_horizon.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "core/geometry/angle.h"
#include "core/geometry/triangle.h"
#include "core/visibility/spherical/recorded_slopes.h"

namespace cullscope::spherical {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Bound on the rounding of cosines stored as float.
constexpr double kFloatError = 1e-7;

/// The sum and the difference of angles given as (cos, sin), without trigonometry.
Vec2 sum(const Vec2& a, const Vec2& b) { return {a.x * b.x - a.y * b.y, a.y * b.x + a.x * b.y}; }
Vec2 difference(const Vec2& a, const Vec2& b) { return {a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y}; }

double slope(double radius, const Vec2& alpha, double eyeDistance) { return radius * alpha.y / (eyeDistance - radius * alpha.x); }

/// The bands that a cap of directions intersects.
struct BandRange {
    uint32_t first = 0, last = 0;
};

/// The sectors that a cap intersects; `first` + i is taken modulo the number of sectors.
struct SectorRange {
    uint32_t first = 0, count = 0;
};

/// A cap of directions around a cell's middle, relative to the bands' axis.
class CapOnBands {
public:
    /// `wider`: radians added to the cap's radius.
    CapOnBands(const ContourBands& bands, const Vec3& middle, const HorizonCells::Cap& cap, double wider = 0.0)
        : m_bands(bands), m_middle(middle), m_radius(cap.cosine, cap.sine), m_angle(cap.angle), m_wider(wider) {
        const double along = std::clamp(glm::dot(middle, bands.axis), -1.0, 1.0);
        m_alpha = {along, std::sqrt(1.0 - along * along)};
    }

    [[nodiscard]] const Vec2& alpha() const { return m_alpha; }
    [[nodiscard]] const Vec2& radius() const { return m_radius; }
    /// Whether the cap contains the axis or its opposite.
    [[nodiscard]] bool holdsAxis() const { return m_radius.y + m_wider >= m_alpha.y || m_radius.x <= 0.0; }

    [[nodiscard]] BandRange bandRange() const {
        const double angle = quickAcos(m_alpha.x), radius = m_angle + m_wider + kQuickAngleError;
        return {m_bands.bandOf(angle - radius), m_bands.bandOf(angle + radius)};
    }

    [[nodiscard]] SectorRange sectorRange() const {
        const SectorRange all{0, m_bands.sectors};
        if (holdsAxis()) return all;
        const double beta = quickAzimuth(glm::dot(m_middle, m_bands.over), glm::dot(m_middle, m_bands.side));
        const double half = 0.5 * kPi - quickAcos((m_radius.y + m_wider) / m_alpha.y) + 2.0 * kQuickAngleError;
        const double perSector = m_bands.sectors / (2.0 * kPi);
        const auto first = int64_t(std::floor((beta - half) * perSector)), last = int64_t(std::floor((beta + half) * perSector));
        const auto sectors = int64_t(m_bands.sectors);
        if (last - first + 1 >= sectors) return all;
        return {uint32_t((first + sectors) % sectors), uint32_t(last - first + 1)};
    }

private:
    const ContourBands& m_bands;
    Vec3 m_middle;
    Vec2 m_radius;
    double m_angle;
    double m_wider;
    Vec2 m_alpha{1.0, 0.0};
};

/// A lower bound on the slope over a cap, for a surface at distances of at least `nearest`: slopes rise and then fall with α, so
/// the smallest is at one of the ends.
double leastSlope(const CapOnBands& cap, double nearest, double eyeDistance) {
    if (cap.holdsAxis()) return 0.0;
    return std::min(slope(nearest, difference(cap.alpha(), cap.radius()), eyeDistance),
                    slope(nearest, sum(cap.alpha(), cap.radius()), eyeDistance));
}

/// An upper bound on the slope over a cap that does not contain the axis, for a surface at distances of at most `farthest`.
double largestSlope(const CapOnBands& cap, double farthest, double eyeDistance) {
    const Vec2 least = difference(cap.alpha(), cap.radius()), most = sum(cap.alpha(), cap.radius());
    const double peak = farthest / eyeDistance;
    if (most.x <= peak && peak <= least.x) return farthest / std::sqrt((eyeDistance - farthest) * (eyeDistance + farthest));
    return std::max(slope(farthest, least, eyeDistance), slope(farthest, most, eyeDistance));
}

/// The smallest slopes of the surface by band and sector.
std::vector<double> leastSlopes(const HorizonCells& cells, const ContourBands& bands, double eyeDistance) {
    std::vector<double> least(bands.table.size(), kInfinity);
    for (uint32_t row = 0; row < cells.surface.rows(); ++row)
        for (uint32_t column = 0; column < cells.surface.columns(); ++column) {
            const CapOnBands cap(bands, cells.surfaceDirections.middle({row, column}), cells.surfaceCaps[row]);
            const double own = leastSlope(cap, cells.surfaceNearest[cells.surface.number({row, column})], eyeDistance);
            const BandRange reached = cap.bandRange();
            const SectorRange sectors = cap.sectorRange();
            for (uint32_t band = reached.first; band <= reached.last; ++band)
                for (uint32_t i = 0; i < sectors.count; ++i) {
                    double& entry = least[size_t(band) * bands.sectors + (sectors.first + i) % bands.sectors];
                    entry = std::min(entry, own);
                }
        }
    return least;
}

void fillHorizon(ContourBands& bands, const std::vector<double>& least) {
    for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
        double horizon = 0.0;
        for (uint32_t band = 0; band < bands.bands; ++band) {
            const size_t place = size_t(band) * bands.sectors + sector;
            bands.table[place] = {least[place], horizon, false};
            horizon = std::max(horizon, least[place]);
        }
    }
}

/// Tests cells against a complete horizon.
class HorizonTest {
public:
    HorizonTest(const SphericalMaps& maps, const ObjectSpaceView& view, const ContourBands& bands)
        : m_maps(maps),
          m_bands(bands),
          m_eyeDistance(glm::length(view.eye)),
          m_reach(view.pixelReach / 64.0),
          m_lowest(bands.bands, kInfinity),
          m_highest(bands.bands, 0.0) {
        for (uint32_t band = 0; band < bands.bands; ++band)
            for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
                m_lowest[band] = std::min(m_lowest[band], bands.at(band, sector).horizon);
                m_highest[band] = std::max(m_highest[band], bands.at(band, sector).horizon);
            }
    }

    [[nodiscard]] SlopeTest test(const CellDirections& directions, const BandCells::Cell& cell,
                                 const HorizonCells::Cap& owned) const {
        if (owned.cosine <= 0.0f) return {};
        const SphericalMaps::Extent extent = m_maps.extent(cell.number);
        // The displacement is converted to an angle at the centre; a cell near the centre may be displaced to any direction.
        if (extent.nearest <= 16.0 * m_reach) return {};
        const CapOnBands cap(m_bands, directions.middle({cell.row, cell.column}), owned, 1.1 * m_reach / extent.nearest);
        if (cap.holdsAxis() && cap.alpha().x > 0.0) return {};
        const double most =
            widened(cap.holdsAxis() ? aroundFarPoint(cap, extent.farthest) : largestSlope(cap, extent.farthest, m_eyeDistance));
        const uint32_t band = cap.bandRange().first;
        // Most cells are below or above the horizon in all sectors of their band.
        if (m_highest[band] <= most) return {SlopeTest::Result::Visible, most, m_highest[band]};
        if (m_lowest[band] > most) return {SlopeTest::Result::Hidden, most, m_lowest[band]};
        const SectorRange sectors = cap.sectorRange();
        double least = kInfinity;
        for (uint32_t i = 0; i < sectors.count; ++i) {
            const double horizon = m_bands.at(band, (sectors.first + i) % m_bands.sectors).horizon;
            if (!(horizon > most)) return {SlopeTest::Result::Visible, most, horizon};
            least = std::min(least, horizon);
        }
        return {SlopeTest::Result::Hidden, most, least};
    }

private:
    /// Upper bound on the slope for a cap that contains the far end of the axis: slopes fall towards it.
    [[nodiscard]] double aroundFarPoint(const CapOnBands& cap, double farthest) const {
        const Vec2 least = difference(cap.alpha(), cap.radius());
        if (least.x > 0.0) return kInfinity;
        return slope(farthest, {least.x, std::max(least.y, 0.0)}, m_eyeDistance);
    }
    [[nodiscard]] double widened(double slope) const {
        return slope * (1.0 + 1e-6) + 1.1 * m_reach * (1.0 + slope) / (m_eyeDistance - m_maps.sphere().radius);
    }

    const SphericalMaps& m_maps;
    const ContourBands& m_bands;
    double m_eyeDistance;
    double m_reach;
    std::vector<double> m_lowest, m_highest;  ///< smallest and largest horizon by band
};

/// A cap from the cosine of its radius, rounded outward.
HorizonCells::Cap capOfCosine(double cosine) {
    cosine -= 2.0 * kFloatError;
    if (cosine <= 0.0) return {};
    return {float(cosine), float(std::sqrt(1.0 - cosine * cosine) + kFloatError),
            float(std::acos(cosine) * (1.0 + 2.0 * kFloatError))};
}

HorizonCells::Cap capOf(const SphericalMaps& maps, const Vec3& middle, uint32_t cell) {
    double least = 1.0;
    for (const uint32_t triangle : maps.centroids(cell))
        for (const Vec3& corner : maps.corners(triangle)) {
            const double length = glm::length(corner);
            least = std::min(least, length > 0.0 ? glm::dot(corner, middle) / length : -1.0);
        }
    return capOfCosine(least);
}

/// A cap around each cell of a row, the whole cell.
HorizonCells::Cap capOfRow(const SphericalGrid& grid, const CellDirections& directions, uint32_t row) {
    const double halfColumn = kPi / grid.columns();
    const Vec2& middle = directions.row(row);
    double least = 1.0;
    for (const uint32_t edge : {row, row + 1}) {
        const Vec2& theta = grid.thetaArm(edge);
        least = std::min(least, middle.x * theta.x + middle.y * theta.y * std::cos(halfColumn));
    }
    return capOfCosine(least);
}

/// A grid whose cells each consist of whole cells of the maps, of at least 2° and with at least four triangles each on average,
/// so that the horizon does not cost more than it saves.
SphericalGrid surfaceGrid(const SphericalGrid& maps, size_t triangles) {
    constexpr double kRowsOfTwoDegrees = 90.0;
    const double rows = std::min(kRowsOfTwoDegrees, std::sqrt(double(triangles) / 8.0));
    uint32_t fine = std::max(1u, uint32_t(maps.rows() / std::max(rows, 1.0)));
    while (fine > 1 && (maps.rows() % fine != 0 || maps.columns() % fine != 0 || maps.rows() < 2 * fine)) --fine;
    return SphericalGrid(maps.columns() / fine, maps.rows() / fine);
}

}  // namespace

HorizonCells::HorizonCells(const SphericalMaps& maps, const BandCells& cells)
    : caps(cells.cells.size()),
      surface(surfaceGrid(maps.grid(), maps.mesh().triangleCount())),
      surfaceDirections(surface),
      surfaceNearest(surface.cellCount(), std::numeric_limits<float>::infinity()) {
    tbb::parallel_for(tbb::blocked_range<size_t>(0, caps.size(), 256), [&](const auto& block) {
        for (size_t i = block.begin(); i < block.end(); ++i) {
            const BandCells::Cell& cell = cells.cells[i];
            caps[i] = capOf(maps, cells.directions.middle({cell.row, cell.column}), cell.number);
        }
    });
    for (uint32_t row = 0; row < surface.rows(); ++row) surfaceCaps.push_back(capOfRow(surface, surfaceDirections, row));
    const uint32_t fine = maps.grid().rows() / surface.rows();
    for (uint32_t number = 0; number < maps.grid().cellCount(); ++number) {
        const auto [row, column] = maps.grid().cell(number);
        float& nearest = surfaceNearest[surface.number({row / fine, column / fine})];
        nearest = maps.extent(number).empty() ? 0.0f : std::min(nearest, maps.extent(number).nearest);
    }
}

std::vector<CellRun> drawnBySlope(const SphericalMaps& maps, const BandCells& cells, const HorizonCells& horizonCells,
                                  const ObjectSpaceView& view, ContourBands& bands, ObjectRecord* record) {
    bands.slopes = true;
    fillHorizon(bands, leastSlopes(horizonCells, bands, glm::length(view.eye)));
    const bool said = record != nullptr && record->tests();
    if (said) sayBandSlopes(bands, *record);
    const HorizonTest horizon(maps, view, bands);
    std::vector<char> drawn(cells.cells.size());
    const auto testCells = [&](const auto& block) {
        for (size_t i = block.begin(); i < block.end(); ++i) {
            const SlopeTest test = horizon.test(cells.directions, cells.cells[i], horizonCells.caps[i]);
            drawn[i] = test.result == SlopeTest::Result::Hidden ? 0 : 1;
            if (said) saySlopeTest(maps, cells.cells[i].number, test, *record);
        }
    };
    const tbb::blocked_range<size_t> all(0, drawn.size(), 2048);
    if (said)
        testCells(all);
    else
        tbb::parallel_for(all, testCells);
    RunCollector runs;
    for (size_t i = 0; i < drawn.size(); ++i) runs.add(cells.cells[i].number, drawn[i] != 0);
    return runs.take();
}

void markDrawnSectors(const SphericalMaps& maps, const BandCells& cells, std::span<const CellRun> drawn, ContourBands& bands) {
    for (BandSector& entry : bands.table) entry.drawn = false;
    auto run = drawn.begin();
    for (const BandCells::Cell& cell : cells.cells) {
        while (run != drawn.end() && run->last <= cell.number) ++run;
        if (run == drawn.end() || cell.number < run->first) continue;
        const CapOnBands cap(bands, cells.directions.middle({cell.row, cell.column}),
                             capOfRow(maps.grid(), cells.directions, cell.row));
        const BandRange reached = cap.bandRange();
        const SectorRange sectors = cap.sectorRange();
        for (uint32_t band = reached.first; band <= reached.last; ++band)
            for (uint32_t i = 0; i < sectors.count; ++i)
                bands.table[size_t(band) * bands.sectors + (sectors.first + i) % bands.sectors].drawn = true;
    }
}

bool isStarShaped(const SphericalMaps& maps, Facing facing) {
    const TriangleMesh& mesh = maps.mesh();
    double turned = 0.0;
    size_t left = 0, right = 0;
    for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
        const std::array<Vec3, 3> corners = maps.corners(triangle);
        const double angle = solidAngle(corners);
        if (angle == 0.0 && glm::cross(corners[1] - corners[0], corners[2] - corners[0]) == Vec3(0.0)) continue;
        turned += angle;
        if (angle == 0.0) return false;  // seen edge-on from the centre: its points cover an arc of directions more than once
        ++(angle > 0.0 ? left : right);
    }
    if ((left > 0 && right > 0) || std::abs(std::abs(turned) - 4.0 * kPi) > 1e-6) return false;
    if (facing == Facing::Front && right > 0) return false;
    return mesh.topology().closed && mesh.topology().consistentlyOriented;
}

}  // namespace cullscope::spherical
