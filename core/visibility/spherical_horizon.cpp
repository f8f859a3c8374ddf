#include "core/visibility/spherical_horizon.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>
#include <numbers>

namespace cullscope {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Of cosines that are kept as float.
constexpr double kFloatError = 1e-7;

/// An angle by its (cos, sin), so that sums need no trigonometry.
Vec2 sum(const Vec2& a, const Vec2& b) { return {a.x * b.x - a.y * b.y, a.y * b.x + a.x * b.y}; }
Vec2 difference(const Vec2& a, const Vec2& b) { return {a.x * b.x + a.y * b.y, a.y * b.x - a.x * b.y}; }

double slope(double radius, const Vec2& alpha, double eyeDistance) { return radius * alpha.y / (eyeDistance - radius * alpha.x); }

/// Bands and sectors that a cap of directions reaches into.
struct Reach {
    uint32_t firstBand = 0, lastBand = 0;
    uint32_t firstSector = 0, sectors = 0;  ///< counted on over β = 0
};

/// A cap of directions around a cell's middle, against the bands' axis.
class CapOnBands {
public:
    /// `radius`: (cos, sin) of the cap's; `wider`: radians that it is wider.
    CapOnBands(const ContourBands& bands, const Vec3& middle, const Vec2& radius, double wider = 0.0)
        : m_bands(bands), m_middle(middle), m_radius(radius), m_wider(wider) {
        const double along = std::clamp(glm::dot(middle, bands.axis), -1.0, 1.0);
        m_alpha = {along, std::sqrt(1.0 - along * along)};
    }

    [[nodiscard]] const Vec2& alpha() const { return m_alpha; }
    [[nodiscard]] const Vec2& radius() const { return m_radius; }
    /// Whether the axis or its opposite lies in the cap.
    [[nodiscard]] bool holdsAxis() const { return m_radius.y + m_wider >= m_alpha.y || m_radius.x <= 0.0; }

    [[nodiscard]] Reach reach() const {
        const double angle = quickAcos(m_alpha.x), radius = quickAcos(m_radius.x) + m_wider + 2.0 * kQuickAngleError;
        Reach reach;
        reach.firstBand = m_bands.bandOf(angle - radius);
        reach.lastBand = m_bands.bandOf(angle + radius);
        reach.sectors = m_bands.sectors;
        if (holdsAxis()) return reach;
        const double beta = quickAzimuth(glm::dot(m_middle, m_bands.over), glm::dot(m_middle, m_bands.side));
        const double half = 0.5 * kPi - quickAcos((m_radius.y + m_wider) / m_alpha.y) + 2.0 * kQuickAngleError;
        const double perSector = m_bands.sectors / (2.0 * kPi);
        const auto first = int64_t(std::floor((beta - half) * perSector)), last = int64_t(std::floor((beta + half) * perSector));
        if (last - first + 1 >= int64_t(m_bands.sectors)) return reach;
        reach.firstSector = uint32_t((first + int64_t(m_bands.sectors)) % int64_t(m_bands.sectors));
        reach.sectors = uint32_t(last - first + 1);
        return reach;
    }

private:
    const ContourBands& m_bands;
    Vec3 m_middle;
    Vec2 m_radius;
    double m_wider;
    Vec2 m_alpha{1.0, 0.0};
};

/// The least slope of a surface that is nowhere nearer than `nearest` over a cap: slopes rise and then fall with α, so that an
/// end has the least.
double leastSlope(const CapOnBands& cap, double nearest, double eyeDistance) {
    if (cap.holdsAxis()) return 0.0;
    return std::min(slope(nearest, difference(cap.alpha(), cap.radius()), eyeDistance),
                    slope(nearest, sum(cap.alpha(), cap.radius()), eyeDistance));
}

/// The largest slope that a surface nowhere farther than `farthest` has over a cap that does not hold the axis.
double largestSlope(const CapOnBands& cap, double farthest, double eyeDistance) {
    const Vec2 least = difference(cap.alpha(), cap.radius()), most = sum(cap.alpha(), cap.radius());
    const double peak = farthest / eyeDistance;
    if (most.x <= peak && peak <= least.x) return farthest / std::sqrt((eyeDistance - farthest) * (eyeDistance + farthest));
    return std::max(slope(farthest, least, eyeDistance), slope(farthest, most, eyeDistance));
}

/// The least slopes by band and sector.
std::vector<double> leastSlopes(const SphericalMaps& maps, const BandCells& cells, const HorizonCells& horizonCells,
                                const ContourBands& bands, double eyeDistance) {
    const SphericalGrid& grid = maps.grid();
    tbb::enumerable_thread_specific<std::vector<double>> tables([&] { return std::vector(bands.table.size(), kInfinity); });
    tbb::parallel_for(tbb::blocked_range<uint32_t>(0, grid.rows(), 8), [&](const auto& rows) {
        std::vector<double>& table = tables.local();
        for (uint32_t row = rows.begin(); row < rows.end(); ++row)
            for (uint32_t column = 0; column < grid.columns(); ++column) {
                const SphericalMaps::Extent& extent = maps.extent(grid.number({row, column}));
                const CapOnBands cap(bands, cells.directions.middle({row, column}), horizonCells.cellRadius[row]);
                const double least = extent.empty() ? 0.0 : leastSlope(cap, extent.nearest, eyeDistance);
                const Reach reach = cap.reach();
                for (uint32_t band = reach.firstBand; band <= reach.lastBand; ++band)
                    for (uint32_t i = 0; i < reach.sectors; ++i) {
                        double& entry = table[size_t(band) * bands.sectors + (reach.firstSector + i) % bands.sectors];
                        entry = std::min(entry, least);
                    }
            }
    });
    std::vector<double> result(bands.table.size(), kInfinity);
    for (const std::vector<double>& table : tables)
        std::transform(result.begin(), result.end(), table.begin(), result.begin(),
                       [](double a, double b) { return std::min(a, b); });
    return result;
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

/// Tests cells against a finished horizon.
class HorizonTest {
public:
    HorizonTest(const SphericalMaps& maps, const MapView& view, const ContourBands& bands)
        : m_maps(maps), m_bands(bands), m_eyeDistance(glm::length(view.eye)), m_reach(view.pixelReach / 64.0) {}

    [[nodiscard]] bool hidden(const CellDirections& directions, const BandCells::Cell& cell,
                              const HorizonCells::Cap& owned) const {
        if (owned.cosine <= 0.0f) return false;
        const SphericalMaps::Extent& extent = m_maps.extent(cell.number);
        // As seen from the centre; a cell that comes near it may be anywhere.
        if (extent.nearest <= 16.0 * m_reach) return false;
        const CapOnBands cap(m_bands, directions.middle({cell.row, cell.column}), {owned.cosine, owned.sine},
                             1.1 * m_reach / extent.nearest);
        if (cap.holdsAxis() && cap.alpha().x > 0.0) return false;
        const double most =
            widened(cap.holdsAxis() ? aroundFarPoint(cap, extent.farthest) : largestSlope(cap, extent.farthest, m_eyeDistance));
        const Reach reach = cap.reach();
        for (uint32_t i = 0; i < reach.sectors; ++i)
            if (!(m_bands.at(reach.firstBand, (reach.firstSector + i) % m_bands.sectors).horizon > most)) return false;
        return true;
    }

private:
    /// Slopes fall towards the far point.
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
};

HorizonCells::Cap capOf(const SphericalMaps& maps, const Vec3& middle, uint32_t cell) {
    double least = 1.0;
    for (const uint32_t triangle : maps.centroids(cell))
        for (const Vec3& corner : maps.corners(triangle)) {
            const double length = glm::length(corner);
            least = std::min(least, length > 0.0 ? glm::dot(corner, middle) / length : -1.0);
        }
    const double cosine = least - 2.0 * kFloatError;
    if (cosine <= 0.0) return {-1.0f, 0.0f};
    return {float(cosine), float(std::sqrt(1.0 - cosine * cosine) + kFloatError)};
}

/// The solid angle of a triangle from the origin, negative where it turns clockwise: van Oosterom & Strackee 1983.
double solidAngle(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    const double turned = glm::dot(a, glm::cross(b, c));
    return 2.0 * std::atan2(turned, la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
}

}  // namespace

HorizonCells::HorizonCells(const SphericalMaps& maps, const BandCells& cells) : caps(cells.cells.size()) {
    const SphericalGrid& grid = maps.grid();
    tbb::parallel_for(tbb::blocked_range<size_t>(0, caps.size(), 256), [&](const auto& block) {
        for (size_t i = block.begin(); i < block.end(); ++i) {
            const BandCells::Cell& cell = cells.cells[i];
            caps[i] = capOf(maps, cells.directions.middle({cell.row, cell.column}), cell.number);
        }
    });
    const double halfColumn = kPi / grid.columns();
    for (uint32_t row = 0; row < grid.rows(); ++row) {
        double least = 1.0;
        for (const uint32_t edge : {row, row + 1}) {
            const Vec2 &middle = cells.directions.row(row), &theta = grid.thetaArm(edge);
            least = std::min(least, middle.x * theta.x + middle.y * theta.y * std::cos(halfColumn));
        }
        least -= 1e-12;
        cellRadius.emplace_back(least, std::sqrt(1.0 - least * least));
    }
}

std::vector<CellRun> drawnBySlope(const SphericalMaps& maps, const BandCells& cells, const HorizonCells& horizonCells,
                                  const MapView& view, ContourBands& bands) {
    bands.slopes = true;
    fillHorizon(bands, leastSlopes(maps, cells, horizonCells, bands, glm::length(view.eye)));
    const HorizonTest test(maps, view, bands);
    std::vector<char> drawn(cells.cells.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, drawn.size(), 1024), [&](const auto& block) {
        for (size_t i = block.begin(); i < block.end(); ++i)
            drawn[i] = test.hidden(cells.directions, cells.cells[i], horizonCells.caps[i]) ? 0 : 1;
    });
    RunCollector runs;
    for (size_t i = 0; i < drawn.size(); ++i) {
        runs.add(cells.cells[i].number, drawn[i] != 0);
        if (drawn[i] == 0) continue;
        const Vec3 middle = cells.directions.middle({cells.cells[i].row, cells.cells[i].column});
        const Reach reach = CapOnBands(bands, middle, {1.0, 0.0}).reach();
        bands.table[size_t(reach.firstBand) * bands.sectors + reach.firstSector].drawn = true;
    }
    return runs.take();
}

bool isStarShaped(const SphericalMaps& maps) {
    const TriangleMesh& mesh = maps.mesh();
    double turned = 0.0;
    size_t left = 0, right = 0;
    for (uint32_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
        const std::array<Vec3, 3> corners = maps.corners(triangle);
        const double angle = solidAngle(corners);
        if (angle == 0.0 && glm::cross(corners[1] - corners[0], corners[2] - corners[0]) == Vec3(0.0)) continue;
        turned += angle;
        if (angle == 0.0) return false;  // edge-on: a whole arc of it lies in one direction
        ++(angle > 0.0 ? left : right);
    }
    if ((left > 0 && right > 0) || std::abs(std::abs(turned) - 4.0 * kPi) > 1e-6) return false;
    return mesh.topology().closed && mesh.topology().consistentlyOriented;
}

}  // namespace cullscope
