#include "core/mesh/polygon.h"

#include <algorithm>
#include <cmath>

namespace cullscope {
namespace {

double doubledArea2d(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Projects along the axis in which the normal is longest, keeping the polygon counter-clockwise.
std::vector<Vec2> projected(std::span<const Vec3> points, const Vec3& normal) {
    const Vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    std::vector<Vec2> flat;
    flat.reserve(points.size());
    for (const Vec3& absolute : points) {
        const Vec3 point = absolute - points.front();
        const Vec2 kept(point[(axis + 1) % 3], point[(axis + 2) % 3]);
        flat.push_back(normal[axis] >= 0.0 ? kept : Vec2(kept.y, kept.x));
    }
    return flat;
}

bool strictlyConvex(std::span<const Vec2> points) {
    const size_t count = points.size();
    for (size_t i = 0; i < count; ++i)
        if (doubledArea2d(points[i], points[(i + 1) % count], points[(i + 2) % count]) <= 0.0) return false;
    return true;
}

void appendFan(size_t corners, std::vector<uint32_t>& triangles) {
    for (uint32_t i = 1; i + 1 < corners; ++i) triangles.insert(triangles.end(), {0, i, i + 1});
}

/// Ear clipping; the corners not yet cut off are a doubly linked ring.
class EarClipper {
public:
    explicit EarClipper(std::span<const Vec2> points) : m_points(points), m_next(points.size()), m_previous(points.size()) {
        for (uint32_t i = 0; i < points.size(); ++i) {
            m_next[i] = i + 1 < points.size() ? i + 1 : 0;
            m_previous[i] = i > 0 ? i - 1 : static_cast<uint32_t>(points.size() - 1);
        }
    }

    void clip(std::vector<uint32_t>& triangles, const Progress& progress) {
        uint32_t corner = 0;
        size_t left = m_points.size();
        size_t refused = 0;
        while (left > 3) {
            if (left % 64 == 0) progress.check();
            // A ring without an ear crosses or touches itself: then any corner is cut off, a convex one if possible.
            if (isEar(corner) || refused >= 2 * left || (refused >= left && areaAt(corner) > 0.0)) {
                triangles.insert(triangles.end(), {m_previous[corner], corner, m_next[corner]});
                m_next[m_previous[corner]] = m_next[corner];
                m_previous[m_next[corner]] = m_previous[corner];
                // Continuing after the next corner spreads the cuts, which avoids needle-like triangles.
                corner = m_next[m_next[corner]];
                --left;
                refused = 0;
            } else {
                corner = m_next[corner];
                ++refused;
            }
        }
        triangles.insert(triangles.end(), {m_previous[corner], corner, m_next[corner]});
    }

private:
    [[nodiscard]] double areaAt(uint32_t corner) const {
        return doubledArea2d(m_points[m_previous[corner]], m_points[corner], m_points[m_next[corner]]);
    }

    [[nodiscard]] bool isEar(uint32_t corner) const {
        if (areaAt(corner) <= 0.0) return false;
        const Vec2& a = m_points[m_previous[corner]];
        const Vec2& b = m_points[corner];
        const Vec2& c = m_points[m_next[corner]];
        for (uint32_t other = m_next[m_next[corner]]; other != m_previous[corner]; other = m_next[other]) {
            const Vec2& point = m_points[other];
            if (point == a || point == b || point == c) continue;
            if (doubledArea2d(a, b, point) >= 0.0 && doubledArea2d(b, c, point) >= 0.0 && doubledArea2d(c, a, point) >= 0.0)
                return false;
        }
        return true;
    }

    std::span<const Vec2> m_points;
    std::vector<uint32_t> m_next;
    std::vector<uint32_t> m_previous;
};

}  // namespace

Vec3 doubledArea(std::span<const Vec3> points) {
    Vec3 area(0.0);
    for (size_t i = 1; i + 1 < points.size(); ++i) area += glm::cross(points[i] - points.front(), points[i + 1] - points.front());
    return area;
}

bool triangulatePolygon(std::span<const Vec3> points, std::vector<uint32_t>& triangles, const Progress& progress) {
    const std::vector<Vec2> flat = projected(points, doubledArea(points));
    const bool convex = strictlyConvex(flat);
    if (convex || flat.size() > kLargestEarClipped) {
        appendFan(flat.size(), triangles);
        return convex;
    }
    EarClipper(flat).clip(triangles, progress);
    return true;
}

}  // namespace cullscope
