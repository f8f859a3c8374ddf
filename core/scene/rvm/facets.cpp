#include "core/scene/rvm/facets.h"

#include <algorithm>
#include <cmath>

#include "core/mesh/polygon.h"

namespace cullscope::rvm {
namespace {

/// Beyond so many pairs of corners a hole is filled in rather than searched for a cut to it.
constexpr size_t kMostPairs = 250'000;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

/// Whether two segments have a point in common besides a common end.
bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    if (a == c || a == d || b == c || b == d) return false;
    return turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0;
}

/// Cuts from an outline to its holes, so that both become one outline.
class HoleCutter {
public:
    HoleCutter(std::vector<Vec3> outline, const Vec3& normal) : m_outline(std::move(outline)), m_normal(normal) {
        const Vec3 size = glm::abs(normal);
        m_axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    }

    /// The holes in an order in which each can be reached: those that cut nothing come later again.
    std::vector<Vec3> cut(std::vector<std::vector<Vec3>> holes) {
        for (std::vector<Vec3>& hole : holes)
            if (glm::dot(doubledArea(hole), m_normal) > 0.0) std::ranges::reverse(hole);
        while (!holes.empty()) {
            const auto joined = std::ranges::find_if(holes, [&](const std::vector<Vec3>& hole) { return join(hole, holes); });
            if (joined == holes.end()) break;
            holes.erase(joined);
        }
        return std::move(m_outline);
    }

private:
    [[nodiscard]] Vec2 flat(const Vec3& point) const {
        const Vec3 from = point - m_outline.front();
        return {from[(m_axis + 1) % 3], from[(m_axis + 2) % 3]};
    }

    [[nodiscard]] bool crosses(const Vec2& a, const Vec2& b, const std::vector<Vec3>& ring) const {
        for (size_t i = 0; i < ring.size(); ++i)
            if (cross(a, b, flat(ring[i]), flat(ring[(i + 1) % ring.size()]))) return true;
        return false;
    }

    bool join(const std::vector<Vec3>& hole, const std::vector<std::vector<Vec3>>& holes) {
        if (hole.size() < 3 || hole.size() * m_outline.size() > kMostPairs) return false;
        struct Pair {
            double away;
            size_t outer, inner;
        };
        std::vector<Pair> pairs;
        for (size_t i = 0; i < m_outline.size(); ++i)
            for (size_t j = 0; j < hole.size(); ++j) pairs.push_back({glm::distance(m_outline[i], hole[j]), i, j});
        std::ranges::sort(pairs, {}, &Pair::away);
        for (const Pair& pair : pairs) {
            const Vec2 a = flat(m_outline[pair.outer]), b = flat(hole[pair.inner]);
            if (crosses(a, b, m_outline)) continue;
            if (std::ranges::any_of(holes, [&](const std::vector<Vec3>& each) { return crosses(a, b, each); })) continue;
            std::vector<Vec3> joined(m_outline.begin(), m_outline.begin() + std::ptrdiff_t(pair.outer) + 1);
            for (size_t i = 0; i <= hole.size(); ++i) joined.push_back(hole[(pair.inner + i) % hole.size()]);
            joined.insert(joined.end(), m_outline.begin() + std::ptrdiff_t(pair.outer), m_outline.end());
            m_outline = std::move(joined);
            return true;
        }
        return false;
    }

    std::vector<Vec3> m_outline;
    Vec3 m_normal;
    int m_axis = 2;
};

}  // namespace

bool appendPolygon(primitive::Surface& surface, const Polygon& polygon, const Mat4& transform, const Progress& progress) {
    if (polygon.contours.empty() || polygon.contours.front().size() < 3) return false;
    std::vector<Vec3> outline = polygon.contours.front();
    const Vec3 area = doubledArea(outline);
    if (!(glm::length(area) > 0.0)) return false;
    if (polygon.contours.size() > 1)
        outline = HoleCutter(std::move(outline), area).cut({polygon.contours.begin() + 1, polygon.contours.end()});
    std::vector<uint32_t> triangles;
    (void)triangulatePolygon(outline, triangles, progress);

    const bool mirrored = glm::determinant(Mat3(transform)) < 0.0;
    const Vec3 normal = glm::transpose(glm::inverse(Mat3(transform))) * area;
    const double length = glm::length(normal);
    const auto first = uint32_t(surface.positions.size());
    for (const Vec3& corner : outline) {
        surface.positions.emplace_back(transform * Vec4(corner, 1.0));
        surface.normals.push_back(length > 0.0 && std::isfinite(length) ? normal / length : Vec3(0.0, 0.0, 1.0));
    }
    for (size_t i = 0; i < triangles.size(); i += 3)
        for (const size_t corner : {size_t{0}, size_t{mirrored ? 2u : 1u}, size_t{mirrored ? 1u : 2u}})
            surface.triangles.push_back(first + triangles[i + corner]);
    return true;
}

}  // namespace cullscope::rvm
