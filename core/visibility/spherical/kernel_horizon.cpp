#include "core/visibility/spherical/kernel_horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/cell_directions.h"

namespace cullscope::spherical {
namespace {

// Bands of α from 18° to 154° in equal steps of its cosine: densest at 90°, where slopes are largest.
constexpr double kFirstCosine = 0.95;
constexpr double kLastCosine = -0.90;
// The share of the kernel's reach reserved for displacement by the picture's snapping.
constexpr double kReachForSnap = 0.2;
constexpr double kWider = 1.0 + 1e-9;

size_t bandsFor(const InnerKernel& kernel) { return kernel.reach() < 0.12 ? 24 : kernel.reach() < 0.24 ? 16 : 12; }

}  // namespace

KernelHorizon::KernelHorizon(const InnerKernel& kernel, const Vec3& eye, double radius, double snap)
    : m_axis(glm::normalize(eye)), m_distance(glm::length(eye)), m_snap(snap) {
    const Vec3 aside = std::abs(m_axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
    m_side = glm::normalize(glm::cross(aside, m_axis));
    m_over = glm::cross(m_axis, m_side);
    m_shrink = snap * (m_distance + radius);
    // A point of the kernel displaced by that much must stay within the directions for which its radius holds. At distances below
    // the least radius, a displacement can reach any direction.
    if (kernel.leastRadius() <= m_shrink * (1.0 + 1.0 / (kReachForSnap * kernel.reach()))) return;
    m_sectors = uint32_t(std::ceil(std::numbers::pi / ((1.0 - kReachForSnap) * kernel.reach())));
    m_bands = bandsFor(kernel);
    fill(kernel);
}

void KernelHorizon::fill(const InnerKernel& kernel) {
    for (uint32_t sector = 0; sector < m_sectors; ++sector) {
        const double beta = kTurn * (sector + 0.5) / m_sectors;
        m_sectorArms.emplace_back(std::cos(beta), std::sin(beta));
    }
    m_band.resize(m_bands);
    m_slopes.resize(m_bands * m_sectors);
    for (size_t b = 0; b < m_bands; ++b) {
        Band& band = m_band[b];
        band.cosine = kFirstCosine + (kLastCosine - kFirstCosine) * double(b) / double(m_bands - 1);
        band.sine = std::sqrt(1.0 - band.cosine * band.cosine);
        band.lowest = std::numeric_limits<double>::infinity();
        for (uint32_t sector = 0; sector < m_sectors; ++sector) {
            double& largest = m_slopes[b * m_sectors + sector];
            largest = slope(radiusAt(kernel, band, sector), band);
            if (b > 0) largest = std::max(largest, m_slopes[(b - 1) * m_sectors + sector]);
            band.lowest = std::min(band.lowest, largest);
            band.highest = std::max(band.highest, largest);
        }
    }
}

Vec3 KernelHorizon::direction(const Band& band, uint32_t sector) const {
    const Vec2& beta = m_sectorArms[sector];
    return band.cosine * m_axis + band.sine * (beta.x * m_side + beta.y * m_over);
}

double KernelHorizon::radiusAt(const InnerKernel& kernel, const Band& band, uint32_t sector) const {
    return std::max(0.0, kernel.radiusAround(direction(band, sector)) - m_shrink);
}

int KernelHorizon::bandUpTo(double cosine) const {
    const double step = (kFirstCosine - kLastCosine) / double(m_bands - 1);
    // Rounding may give one band too many; the comparison of cosines corrects that.
    const int band = std::min(int(std::floor((kFirstCosine - cosine) / step)), int(m_bands) - 1);
    return band >= 0 && m_band[size_t(band)].cosine < cosine ? band - 1 : std::max(band, -1);
}

KernelHorizon::Comparison KernelHorizon::compare(const Vec3& middle, double radius) const {
    const double towardsEye = glm::dot(middle, m_axis), length = glm::length(middle);
    const double ahead = m_distance - towardsEye;
    const Vec3 across = middle - towardsEye * m_axis;
    const double aside = glm::length(across);
    radius += m_snap * (ahead + aside + radius);
    if (ahead <= radius) return {Reach::Open, std::numeric_limits<double>::infinity(), 0.0};
    const double most = (aside + radius) / (ahead - radius) * kWider;
    const double least = std::max(0.0, aside - radius) / (ahead + radius) / kWider;
    // The range of α of the sphere's points: the α of its middle ± the angle of its radius.
    const double cosine = length > 0.0 ? std::clamp(towardsEye / length, -1.0, 1.0) : 1.0;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double wideSine = length > radius ? radius / length * kWider : 1.0;
    const double wideCosine = std::sqrt(std::max(0.0, 1.0 - wideSine * wideSine));
    const bool aroundCentre = length <= radius;
    const double nearestCosine = aroundCentre || cosine >= wideCosine ? 1.0 : cosine * wideCosine + sine * wideSine;
    const double farthestCosine = aroundCentre || cosine <= -wideCosine ? -1.0 : cosine * wideCosine - sine * wideSine;
    const int far = bandUpTo(farthestCosine - 1e-12);
    if (far < 0) return {Reach::Visible, least, 0.0};
    if (m_band[size_t(far)].highest <= least) return {Reach::Visible, least, m_band[size_t(far)].highest};
    const int near = bandUpTo(nearestCosine + 1e-12);
    if (near < 0) return {Reach::Open, most, 0.0};
    if (m_band[size_t(near)].highest <= most) return {Reach::Open, most, m_band[size_t(near)].highest};
    if (m_band[size_t(near)].lowest > most) return {Reach::Hidden, most, m_band[size_t(near)].lowest};
    if (radius >= aside) return {Reach::Open, most, m_band[size_t(near)].lowest};
    const double beta = quickAzimuth(glm::dot(across, m_over), glm::dot(across, m_side));
    const double half = 0.5 * std::numbers::pi * radius / aside + 2.0 * kQuickAngleError;
    const double perSector = m_sectors / kTurn;
    const auto first = int64_t(std::floor((beta - half) * perSector)), last = int64_t(std::floor((beta + half) * perSector));
    const auto sectors = int64_t(m_sectors);
    double lowest = m_band[size_t(near)].highest;
    for (int64_t sector = first; sector <= std::min(last, first + sectors - 1); ++sector) {
        const double slope = m_slopes[size_t(near) * m_sectors + size_t((sector + sectors) % sectors)];
        if (!(slope > most)) return {Reach::Open, most, slope};
        lowest = std::min(lowest, slope);
    }
    return {Reach::Hidden, most, lowest};
}

std::vector<Vec3> KernelHorizon::outline(const InnerKernel& kernel) const {
    std::vector<Vec3> points;
    for (uint32_t sector = 0; sector < m_sectors; ++sector) {
        const auto highest = std::max_element(m_band.begin(), m_band.end(), [&](const Band& a, const Band& b) {
            return slope(radiusAt(kernel, a, sector), a) < slope(radiusAt(kernel, b, sector), b);
        });
        points.push_back(radiusAt(kernel, *highest, sector) * direction(*highest, sector));
    }
    return points;
}

}  // namespace cullscope::spherical
