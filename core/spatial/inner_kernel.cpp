#include "core/spatial/inner_kernel.h"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/message.h"
#include "core/geometry/rounding.h"
#include "core/geometry/triangle.h"

namespace cullscope {
namespace {

using Range = tbb::blocked_range<uint32_t>;

// A fixed size, so that sums have the same order on every machine.
constexpr uint32_t kTrianglesPerTask = 8192;
constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Share of the bounding sphere's radius: a kernel with a smaller least radius is not used, because it hides nothing.
constexpr double kThin = 0.02;

/// Cells of about 6°, 11° and 22°, at most one for eight triangles.
uint32_t levelFor(size_t triangles) { return triangles >= 8 * 1024 ? 5 : triangles >= 8 * 256 ? 4 : 3; }

/// The corners of a triangle relative to the centre.
TriangleCorners cornersOf(const TriangleMesh& mesh, uint32_t triangle) {
    TriangleCorners corners;
    for (size_t i = 0; i < 3; ++i)
        corners[i] = Vec3(mesh.positions()[mesh.indices()[3 * size_t(triangle) + i]]) - mesh.localSphere().centre;
    return corners;
}

/// The unit vector (cos, sin) of an angle, so that sums of angles need no trigonometry.
Vec2 armOf(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// A circular cap of directions that contains a cell of the map.
struct Cap {
    Vec3 middle{0.0};
    Vec2 radius{1.0, 0.0};  ///< angle of the radius as (cos, sin)

    /// Whether the cap intersects the cap around `other` with a radius given by (cos, sin).
    [[nodiscard]] bool reachedFrom(const Vec3& other, const Vec2& reach) const {
        // For sums beyond half a turn the caps always intersect; their cosine would rise again.
        const double sine = radius.y * reach.x + radius.x * reach.y;
        return sine <= 0.0 || glm::dot(middle, other) >= radius.x * reach.x - radius.y * reach.y;
    }
};

Cap capOf(uint32_t level, uint32_t x, uint32_t y) {
    const double size = 1.0 / double(1U << level);
    const Vec2 low(x * size, y * size);
    Cap cap{directionAt(MapLayout::Octahedral, low + 0.5 * size), {}};
    double cosine = 1.0;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)})
        cosine = std::min(cosine, glm::dot(cap.middle, directionAt(MapLayout::Octahedral, low + size * corner)) - 1e-12);
    cap.radius = {cosine, std::sqrt(1.0 - cosine * cosine)};
    return cap;
}

/// By row (y), then x.
std::vector<Cap> capsOf(uint32_t level) {
    std::vector<Cap> caps;
    for (uint32_t y = 0; y < 1U << level; ++y)
        for (uint32_t x = 0; x < 1U << level; ++x) caps.push_back(capOf(level, x, y));
    return caps;
}

/// Caps of the kernel's cells, and of larger cells with which most of those are skipped.
struct CapsByLevel {
    static constexpr uint32_t kLevelsBetween = 2;

    explicit CapsByLevel(uint32_t ofFine) : level(ofFine), fine(capsOf(level)), coarse(capsOf(level - kLevelsBetween)) {}

    /// Calls visit(place) for the cells that may intersect a cap.
    template <typename Visit>
    void forEachReachedFrom(const Vec3& middle, const Vec2& reach, const Visit& visit) const {
        const uint32_t across = 1U << (level - kLevelsBetween), within = 1U << kLevelsBetween;
        for (uint32_t large = 0; large < coarse.size(); ++large) {
            if (!coarse[large].reachedFrom(middle, reach)) continue;
            for (uint32_t i = 0; i < within * within; ++i) {
                const uint32_t x = large % across * within + i % within, y = large / across * within + i / within;
                const uint32_t place = (y << level) + x;
                if (fine[place].reachedFrom(middle, reach)) visit(place);
            }
        }
    }

    uint32_t level;
    std::vector<Cap> fine, coarse;
};

/// The winding number of the surface around the centre.
double windingNumber(const TriangleMesh& mesh) {
    const auto count = uint32_t(mesh.triangleCount());
    const double angle = tbb::parallel_deterministic_reduce(
        Range(0, count, kTrianglesPerTask), 0.0,
        [&](const Range& part, double sum) {
            for (uint32_t triangle = part.begin(); triangle < part.end(); ++triangle)
                sum += solidAngle(cornersOf(mesh, triangle));
            return sum;
        },
        std::plus<>());
    return angle / (4.0 * std::numbers::pi);
}

/// The nearest surface by cell. A triangle that extends far beyond its centroid's direction is added to every cell that it may
/// touch.
class NearestByCell {
public:
    NearestByCell(const TriangleMesh& mesh, const CapsByLevel& caps, double overhang)
        : m_mesh(mesh), m_caps(caps), m_leastCosine(std::cos(overhang)), m_nearest(caps.fine.size(), kInfinity) {}

    void add(uint32_t triangle) {
        const TriangleCorners corners = cornersOf(m_mesh, triangle);
        const Vec3 sum = corners[0] + corners[1] + corners[2];
        const double length = glm::length(sum);
        double cosine = length > 0.0 ? 1.0 : -1.0;
        for (const Vec3& corner : corners) {
            const double product = length * glm::length(corner);
            cosine = product > 0.0 ? std::min(cosine, glm::dot(sum, corner) / product) : -1.0;
        }
        const float nearest = floatBelow(nearestDistance(corners) * (1.0 - 1e-9));
        if (cosine > m_leastCosine) {
            const MapCell cell = octahedralCell(sum, m_caps.level);
            lower((cell.y << m_caps.level) + cell.x, nearest);
        } else {
            addAround(length > 0.0 ? sum / length : Vec3(0, 0, 1), cosine, nearest);
        }
    }
    void join(const NearestByCell& other) {
        for (uint32_t place = 0; place < m_nearest.size(); ++place) lower(place, other.m_nearest[place]);
    }
    [[nodiscard]] std::vector<float> take() { return std::move(m_nearest); }

private:
    void lower(uint32_t place, float nearest) { m_nearest[place] = std::min(m_nearest[place], nearest); }
    void addAround(const Vec3& middle, double cosine, float nearest) {
        // For a triangle that is not within a hemisphere, the corners give no bound on its directions.
        const Vec2 reach = armOf(cosine > 0.01 ? std::acos(cosine) + 1e-9 : std::numbers::pi);
        m_caps.forEachReachedFrom(middle, reach, [&](uint32_t place) { lower(place, nearest); });
    }

    const TriangleMesh& m_mesh;
    const CapsByLevel& m_caps;
    double m_leastCosine;
    std::vector<float> m_nearest;
};

}  // namespace

const char* InnerKernel::stateName(State state) {
    switch (state) {
        case State::Filled:
            return CULLSCOPE_TR("filled");
        case State::NotClosed:
            return CULLSCOPE_TR("the mesh is not closed or not consistently oriented");
        case State::CentreOutside:
            return CULLSCOPE_TR("the centre of the bounding sphere lies outside the solid");
        case State::TooThin:
            return CULLSCOPE_TR("the surface comes too near to the centre of the bounding sphere");
        case State::NotAsked:
            break;
    }
    return CULLSCOPE_TR("meshes of more than five million triangles are not asked whether they are closed");
}

InnerKernel::InnerKernel(const TriangleMesh& mesh)
    : m_level(levelFor(mesh.triangleCount())),
      m_reach(std::numbers::pi / double(1U << m_level)),
      m_overhang(0.25 * m_reach),
      m_state(stateOf(mesh)) {
    if (m_state != State::Filled) return;
    lookAround(nearestSurface(mesh));
    if (m_least > kThin * mesh.localSphere().radius) return;
    m_state = State::TooThin;
    m_radii = m_radiiAround = {};
}

InnerKernel::State InnerKernel::stateOf(const TriangleMesh& mesh) {
    if (mesh.triangleCount() > kOptionalAnalysisLimit) return State::NotAsked;
    const Topology& topology = mesh.topology();
    if (!topology.closed || !topology.consistentlyOriented) return State::NotClosed;
    const double winding = windingNumber(mesh);
    m_outward = winding > 0.0;
    // With the centre on the surface the sum is no whole number.
    const bool whole = std::abs(winding - std::round(winding)) < 0.01;
    return whole && std::abs(winding) > 0.5 ? State::Filled : State::CentreOutside;
}

std::vector<float> InnerKernel::nearestSurface(const TriangleMesh& mesh) const {
    const CapsByLevel caps(m_level);
    tbb::enumerable_thread_specific<NearestByCell> parts([&] { return NearestByCell(mesh, caps, m_overhang); });
    const auto count = uint32_t(mesh.triangleCount());
    tbb::parallel_for(Range(0, count, kTrianglesPerTask), [&](const Range& range) {
        NearestByCell& part = parts.local();
        for (uint32_t triangle = range.begin(); triangle < range.end(); ++triangle) part.add(triangle);
    });
    NearestByCell all(mesh, caps, m_overhang);
    for (const NearestByCell& part : parts) all.join(part);
    return all.take();
}

void InnerKernel::lookAround(const std::vector<float>& nearest) {
    const CapsByLevel caps(m_level);
    m_radii.assign(caps.fine.size(), kInfinity);
    m_radiiAround.assign(caps.fine.size(), kInfinity);
    tbb::parallel_for(Range(0, uint32_t(caps.fine.size()), 64), [&](const Range& part) {
        for (uint32_t place = part.begin(); place < part.end(); ++place) {
            const Cap& cap = caps.fine[place];
            const double radius = std::acos(cap.radius.x) + m_overhang + 1e-9;
            const Vec2 near = armOf(radius), far = armOf(radius + m_reach);
            caps.forEachReachedFrom(cap.middle, far, [&](uint32_t other) {
                m_radiiAround[place] = std::min(m_radiiAround[place], nearest[other]);
                if (caps.fine[other].reachedFrom(cap.middle, near)) m_radii[place] = std::min(m_radii[place], nearest[other]);
            });
        }
    });
    // Around a centre inside the solid there is surface in every direction: a radius that is still infinite was not found, and
    // becomes 0.
    for (std::vector<float>* radii : {&m_radii, &m_radiiAround})
        for (float& radius : *radii) radius = std::isfinite(radius) ? radius : 0.0f;
    m_least = *std::min_element(m_radii.begin(), m_radii.end());
}

}  // namespace cullscope
