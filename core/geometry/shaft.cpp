#include "core/geometry/shaft.h"

#include <algorithm>

namespace cullscope {

Shaft::Shaft(const Box3& from, const Box3& to) {
    Box3 both = from;
    both.add(to);
    m_origin = both.centre();
    m_slack = both.diagonal() * 0x1p-44 + glm::length(m_origin) * 0x1p-48;
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 normal(0.0);
        normal[axis] = 1.0;
        add(normal, both.max);
        add(-normal, both.min);
    }
    // In each quarter of the plane of two axes the corners of the boxes that lie farthest out are joined, unless one of them lies
    // farther out along both axes.
    for (int third = 0; third < 3; ++third) {
        const int u = (third + 1) % 3, v = (third + 2) % 3;
        for (int quarter = 0; quarter < 4; ++quarter) {
            const double alongU = (quarter & 1) != 0 ? 1.0 : -1.0, alongV = (quarter & 2) != 0 ? 1.0 : -1.0;
            const auto corner = [&](const Box3& box) {
                Vec3 result = box.min;
                if (alongU > 0.0) result[u] = box.max[u];
                if (alongV > 0.0) result[v] = box.max[v];
                return result;
            };
            const Vec3 step = corner(to) - corner(from);
            const double stepU = alongU * step[u], stepV = alongV * step[v];
            if (!(stepU * stepV < 0.0)) continue;
            Vec3 normal(0.0);
            normal[u] = alongU * std::abs(step[v]);
            normal[v] = alongV * std::abs(step[u]);
            add(glm::normalize(normal), corner(from));
        }
    }
}

void Shaft::add(const Vec3& normal, const Vec3& on) { m_sides[m_count++] = {normal, glm::dot(normal, on - m_origin)}; }

bool Shaft::mayMeet(const Vec3& a, const Vec3& b) const {
    constexpr double kRounding = 0x1p-40;
    const Vec3 fromA = a - m_origin, fromB = b - m_origin;
    double begin = 0.0, end = 1.0;
    for (size_t i = 0; i < m_count; ++i) {
        const double outA = glm::dot(m_sides[i].normal, fromA) - m_sides[i].offset - m_slack;
        const double outB = glm::dot(m_sides[i].normal, fromB) - m_sides[i].offset - m_slack;
        if (outA > 0.0 && outB > 0.0) return false;
        if (outA > 0.0)
            begin = std::max(begin, outA / (outA - outB));
        else if (outB > 0.0)
            end = std::min(end, outA / (outA - outB));
        if (begin > end + kRounding) return false;
    }
    return true;
}

}  // namespace cullscope
