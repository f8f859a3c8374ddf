#pragma once

#include <algorithm>

#include "core/geometry/frustum.h"
#include "tests/support/exact_convex.h"

namespace cullscope::test {

/// The frustum defined by the library's doubles, evaluated exactly.
class ExactFrustum {
public:
    explicit ExactFrustum(const Frustum& frustum) : ExactFrustum(frustum, frustum.farDistance) {}
    /// With another far distance than the frustum's.
    ExactFrustum(const Frustum& frustum, Quad farDistance)
        : m_right(quad(frustum.right)),
          m_up(quad(frustum.up)),
          m_forward(quad(frustum.forward)),
          m_frustum(frustum),
          m_far(farDistance) {}

    [[nodiscard]] Distances distances(const QuadVector& point) const {
        const Quad x = dot(m_right, point), y = dot(m_up, point), depth = dot(m_forward, point);
        const Quad wide = Quad(m_frustum.halfWidth) + Quad(m_frustum.tanHalfWidth) * depth,
                   tall = Quad(m_frustum.halfHeight) + Quad(m_frustum.tanHalfHeight) * depth;
        return {wide + x, wide - x, tall + y, tall - y, depth - m_frustum.nearDistance, m_far - depth};
    }
    [[nodiscard]] bool meets(const QuadBox& box) const {
        return test::meets(
            box, [&](const QuadVector& point) { return distances(point); }, scaled(m_forward, m_frustum.nearDistance));
    }
    /// The distance of a point from the nearest point of the frustum; 0 inside.
    [[nodiscard]] Quad distance(const QuadVector& point) const {
        if (inside(distances(point))) return 0;
        std::array<QuadVector, 8> corners;
        for (size_t i = 0; i < 8; ++i) {
            const Quad depth = i < 4 ? m_frustum.nearDistance : m_far;
            const Quad x = (m_frustum.halfWidth + depth * m_frustum.tanHalfWidth) * (i % 4 == 0 || i % 4 == 3 ? -1 : 1);
            const Quad y = (m_frustum.halfHeight + depth * m_frustum.tanHalfHeight) * (i % 4 < 2 ? -1 : 1);
            corners[i] = plus(plus(scaled(m_right, x), scaled(m_up, y)), scaled(m_forward, depth));
        }
        constexpr size_t kFaces[6][4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {0, 3, 7, 4}, {1, 2, 6, 5}, {0, 1, 5, 4}, {3, 2, 6, 7}};
        Quad least = -1;
        for (const auto& face : kFaces)
            for (const size_t third : {2, 3}) {
                const Quad found = squareToTriangle(point, corners[face[0]], corners[face[third - 1]], corners[face[third]]);
                if (least < 0 || found < least) least = found;
            }
        return root(least);
    }

private:
    static Quad squareToSegment(const QuadVector& point, const QuadVector& a, const QuadVector& b) {
        const QuadVector along = minus(b, a), from = minus(point, a);
        Quad share = dot(along, from) / dot(along, along);
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        const QuadVector rest = minus(from, scaled(along, share));
        return dot(rest, rest);
    }
    static Quad squareToTriangle(const QuadVector& point, const QuadVector& a, const QuadVector& b, const QuadVector& c) {
        const QuadVector normal = cross(minus(b, a), minus(c, a));
        const auto within = [&](const QuadVector& from, const QuadVector& to) {
            return dot(cross(normal, minus(to, from)), minus(point, from)) >= 0;
        };
        if (within(a, b) && within(b, c) && within(c, a)) {
            const Quad height = dot(normal, minus(point, a));
            return height * height / dot(normal, normal);
        }
        return std::min({squareToSegment(point, a, b), squareToSegment(point, b, c), squareToSegment(point, c, a)});
    }

    QuadVector m_right, m_up, m_forward;
    Frustum m_frustum;
    Quad m_far;
};

}  // namespace cullscope::test
