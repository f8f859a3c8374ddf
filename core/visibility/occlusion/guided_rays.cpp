#include "core/visibility/occlusion/guided_rays.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "core/geometry/triangle.h"

namespace cullscope::occlusion {
namespace {

/// By how much of its size a triangle is enlarged, whose border is looked past; and at least by so much of its distance.
constexpr double kBorder = 0.05;
constexpr double kLeastBorder = 1e-4;
/// A ray ends before the border of a triangle where it is so much shorter.
constexpr double kBefore = 0.98;
constexpr uint64_t kTurnsBetweenLooks = 1024;  // for a stop request

Vec3 pointIn(const Box3& box, Random& random) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return box.min + (box.max - box.min) * Vec3(x, y, z);
}

/// Uniform over its area (Osada et al. 2002).
Vec3 pointOn(const TriangleCorners& corners, Random& random) {
    const double root = std::sqrt(random.unit()), along = random.unit();
    return (1.0 - root) * corners[0] + root * (1.0 - along) * corners[1] + root * along * corners[2];
}

/// Where a line enters a box and leaves it again, as multiples of its direction; none where it passes by.
std::optional<std::pair<double, double>> through(const Box3& box, const Vec3& from, const Vec3& direction) {
    double begin = -std::numeric_limits<double>::infinity(), end = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (box.min[axis] - from[axis]) / direction[axis], high = (box.max[axis] - from[axis]) / direction[axis];
        if (std::isnan(low) || std::isnan(high)) continue;
        begin = std::max(begin, std::min(low, high));
        end = std::min(end, std::max(low, high));
    }
    if (!(begin <= end)) return std::nullopt;
    return std::pair(begin, end);
}

}  // namespace

class GuidedRays::OfCell {
public:
    OfCell(const GuidedRays& guided, const Box3& cell, uint64_t seed, std::vector<uint8_t>& seen)
        : m_scene(guided.m_scene), m_rays(guided.m_rays), m_cell(cell), m_random(seed), m_seen(seen) {
        for (uint32_t i = 0; i < seen.size(); ++i)
            if (seen[i] == 0 && m_scene.meshOf(i).triangleCount() > 0) m_unseen.push_back(i);
    }

    uint64_t run(uint64_t most, Work& work, const Progress& progress) {
        work.metIn.resize(m_scene.triangleCount(), 0);
        ++work.cell;
        m_work = &work;
        for (uint64_t turn = 0; m_shot < most && unseenLeft(); ++turn) {
            if (turn % kTurnsBetweenLooks == 0) progress.check();
            if (turn % 3 == 0)
                shoot(pointIn(m_cell, m_random), m_random.direction());
            else if (turn % 3 == 1)
                shootAt(m_unseen[size_t(m_random.bits() % m_unseen.size())]);
            else if (!m_found.empty())
                lookAround();
        }
        return m_shot;
    }

private:
    struct Found {
        Vec3 from;
        uint32_t instance = 0, triangle = 0;
    };

    /// Forgets those that were seen since; whether any are left.
    bool unseenLeft() {
        if (m_newlySeen) std::erase_if(m_unseen, [&](uint32_t instance) { return m_seen[instance] != 0; });
        m_newlySeen = false;
        return !m_unseen.empty();
    }

    void shootAt(uint32_t instance) {
        const Vec3 from = pointIn(m_cell, m_random);
        const uint64_t triangle = m_random.bits() % m_scene.meshOf(instance).triangleCount();
        shoot(from, pointOn(cornersOf(instance, uint32_t(triangle)), m_random) - from);
    }

    [[nodiscard]] TriangleCorners cornersOf(uint32_t instance, uint32_t triangle) const {
        const TriangleMesh& mesh = m_scene.meshOf(instance);
        const Mat4& placed = m_scene.instances()[instance].worldFromMesh;
        TriangleCorners corners;
        for (size_t c = 0; c < 3; ++c)
            corners[c] = Vec3(placed * Vec4(mesh.position(mesh.indices()[3 * size_t(triangle) + c]), 1.0));
        return corners;
    }

    std::optional<SceneRays::Hit> shoot(const Vec3& from, const Vec3& direction) {
        ++m_shot;
        if (!(glm::dot(direction, direction) > 0.0)) return std::nullopt;
        const std::optional<SceneRays::Hit> hit = m_rays.first(from, direction);
        if (!hit) return hit;
        if (m_seen[hit->instance] == 0) {
            m_seen[hit->instance] = 1;
            m_newlySeen = true;
        }
        if (m_work == nullptr) return hit;
        uint32_t& met = m_work->metIn[m_scene.firstTriangle(hit->instance) + hit->triangle];
        if (met != m_work->cell) m_found.push_back({from, hit->instance, hit->triangle});
        met = m_work->cell;
        return hit;
    }

    /// Rays past the corners and the middles of the edges of the triangle that was found first and not looked around yet.
    void lookAround() {
        const Found found = m_found.front();
        m_found.pop_front();
        const std::vector<Vec3> border = borderOf(cornersOf(found.instance, found.triangle), found.from);
        for (const Vec3& point : border) {
            const std::optional<SceneRays::Hit> hit = shoot(found.from, point - found.from);
            if (hit && hit->distance < kBefore) lookPast(found.from, point, *hit);
        }
    }

    [[nodiscard]] static std::vector<Vec3> borderOf(const TriangleCorners& corners, const Vec3& from) {
        const Vec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
        const double least = kLeastBorder * glm::length(centre - from);
        TriangleCorners enlarged;
        for (size_t i = 0; i < 3; ++i) {
            const Vec3 out = corners[i] - centre;
            const double length = glm::length(out);
            enlarged[i] = length > 0.0 ? corners[i] + out * std::max(kBorder, least / length) : corners[i];
        }
        std::vector<Vec3> border;
        for (size_t i = 0; i < 3; ++i) {
            border.push_back(enlarged[i]);
            border.push_back(0.5 * (enlarged[i] + enlarged[(i + 1) % 3]));
        }
        return border;
    }

    /// Looks at a point from that place of the cell from which it is seen past the nearest border of what was in the way.
    void lookPast(const Vec3& from, const Vec3& point, const SceneRays::Hit& obstacle) {
        const Vec3 met = from + obstacle.distance * (point - from);
        const std::vector<Vec3> border = borderOf(cornersOf(obstacle.instance, obstacle.triangle), from);
        const Vec3 past = *std::ranges::min_element(border, {}, [&](const Vec3& at) { return glm::dot(at - met, at - met); });
        const std::optional<std::pair<double, double>> inCell = through(m_cell, point, past - point);
        if (!inCell || !(inCell->first > 0.0) || !std::isfinite(inCell->first)) return;
        const double at = m_random.between(inCell->first, inCell->second);
        const Vec3 newFrom = point + at * (past - point);
        shoot(newFrom, point - newFrom);
    }

    const Scene& m_scene;
    const SceneRays& m_rays;
    const Box3& m_cell;
    Random m_random;
    std::vector<uint8_t>& m_seen;
    bool m_newlySeen = false;
    std::vector<uint32_t> m_unseen;
    std::deque<Found> m_found;
    Work* m_work = nullptr;
    uint64_t m_shot = 0;
};

uint64_t GuidedRays::sample(const Box3& cell, const Options& options, Work& work, std::vector<uint8_t>& seen,
                            const Progress& progress) const {
    return OfCell(*this, cell, options.seed, seen).run(options.rays, work, progress);
}

}  // namespace cullscope::occlusion
