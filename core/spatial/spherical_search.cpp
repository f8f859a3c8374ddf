#include "core/spatial/spherical_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cullscope {

namespace {

// Tolerance of barycentric coordinates, so that a ray through the edge of two triangles hits one of them.
constexpr double kEdgeTolerance = 1e-12;

/// The ray parameter at which the zenith angle along the ray has its extreme; none where it has none.
std::optional<double> turningPoint(const Ray& ray) {
    const double along = glm::dot(ray.origin, ray.direction);
    const double slope = ray.direction.z * along - ray.origin.z * glm::dot(ray.direction, ray.direction);
    if (slope == 0.0) return std::nullopt;
    return (ray.origin.z * along - ray.direction.z * glm::dot(ray.origin, ray.origin)) / slope;
}

class Crossings {
public:
    Crossings(const SphericalGrid& grid, const Ray& ray, const Span& span) : m_grid(grid), m_ray(ray), m_span(span) {
        addRows();
        addColumns();
        std::sort(m_places.begin(), m_places.end());
        m_places.push_back(span.to);
    }

    [[nodiscard]] const std::vector<double>& places() const { return m_places; }

private:
    void add(double t) {
        if (t > m_span.from && t < m_span.to) m_places.push_back(t);
    }

    void addRows() {
        const auto rowAt = [&](double t) { return m_grid.cellOf(m_ray.at(t)).row; };
        uint32_t first = std::min(rowAt(m_span.from), rowAt(m_span.to)), last = std::max(rowAt(m_span.from), rowAt(m_span.to));
        if (const auto turn = turningPoint(m_ray); turn && *turn > m_span.from && *turn < m_span.to) {
            first = std::min(first, rowAt(*turn));
            last = std::max(last, rowAt(*turn));
            add(*turn);
        }
        // One more row on either side, because the turning point is rounded.
        first = first > 0 ? first - 1 : 0;
        last = std::min(last + 2, m_grid.rows());
        for (uint32_t row = std::max(first, 1u); row <= std::min(last, m_grid.rows() - 1); ++row) addCone(m_grid.thetaArm(row).x);
    }

    /// The intersections with the cone z = cosine · |p|, which is the border of two rows.
    void addCone(double cosine) {
        const Vec3 &o = m_ray.origin, &d = m_ray.direction;
        const double squared = cosine * cosine;
        const double a = d.z * d.z - squared * glm::dot(d, d);
        const double b = o.z * d.z - squared * glm::dot(o, d);
        const double c = o.z * o.z - squared * glm::dot(o, o);
        // b² − a c in a form without a common factor of the cosine: near the equator the difference would cancel completely.
        const Vec3 turned = d.z * o - o.z * d, moment = glm::cross(o, d);
        const double discriminant = glm::dot(turned, turned) - squared * glm::dot(moment, moment);
        if (discriminant < 0.0) return;
        // Both roots without cancellation. One may lie on the mirrored cone; it only divides a cell's piece in two, which
        // walkedCells joins.
        const double q = -(b + std::copysign(std::abs(cosine) * std::sqrt(discriminant), b));
        if (a != 0.0) add(q / a);
        if (q != 0.0) add(c / q);
    }

    void addColumns() {
        const Vec3 &o = m_ray.origin, &d = m_ray.direction;
        const double turn = o.x * d.y - o.y * d.x;  // sign: direction in which the azimuth changes
        if (turn == 0.0) {
            // A ray through the axis: its azimuth jumps by half a turn there.
            const double flat = d.x * d.x + d.y * d.y;
            if (flat > 0.0) add(-(o.x * d.x + o.y * d.y) / flat);
            return;
        }
        const uint32_t columns = m_grid.columns();
        uint32_t from = m_grid.cellOf(m_ray.at(m_span.from)).column, to = m_grid.cellOf(m_ray.at(m_span.to)).column;
        if (turn < 0.0) std::swap(from, to);
        // One more column on either side: end points on a boundary are rounded to one of its sides.
        const uint32_t steps = std::min(columns, (to + columns - from) % columns + 2);
        for (uint32_t step = 0; step < steps; ++step) {
            const Vec2& arm = m_grid.phiArm((from + step) % columns);
            const double across = -arm.y * d.x + arm.x * d.y;
            if (across != 0.0) add((arm.y * o.x - arm.x * o.y) / across);
        }
    }

    const SphericalGrid& m_grid;
    const Ray& m_ray;
    Span m_span;
    std::vector<double> m_places;
};

}  // namespace

std::optional<Span> throughSphere(const Ray& ray, double radius) {
    const double length = glm::length(ray.direction);
    const double along = -glm::dot(ray.origin, ray.direction) / (length * length);
    const Vec3 nearest = ray.at(along);
    const double aside = glm::dot(nearest, nearest);
    if (aside > radius * radius) return std::nullopt;
    const double half = std::sqrt(radius * radius - aside) / length;
    if (along + half < 0.0) return std::nullopt;
    return Span{std::max(0.0, along - half), along + half};
}

std::vector<WalkedCell> walkedCells(const SphericalGrid& grid, const Ray& ray, const Span& span) {
    std::vector<WalkedCell> walked;
    double from = span.from;
    const Crossings crossings(grid, ray, span);
    for (const double to : crossings.places()) {
        const SphericalGrid::Cell cell = grid.cellOf(ray.at(0.5 * (from + to)));
        if (!walked.empty() && walked.back().cell == cell)
            walked.back().span.to = to;
        else
            walked.push_back({cell, {from, to}});
        from = to;
    }
    return walked;
}

std::optional<double> hit(const Ray& ray, const std::array<Vec3, 3>& corners) {
    // Möller & Trumbore 1997.
    const Vec3 ab = corners[1] - corners[0], ac = corners[2] - corners[0];
    const Vec3 p = glm::cross(ray.direction, ac);
    const double determinant = glm::dot(ab, p);
    if (determinant == 0.0) return std::nullopt;
    const Vec3 offset = ray.origin - corners[0];
    const double u = glm::dot(offset, p) / determinant;
    if (u < -kEdgeTolerance || u > 1.0 + kEdgeTolerance) return std::nullopt;
    const Vec3 q = glm::cross(offset, ab);
    const double v = glm::dot(ray.direction, q) / determinant;
    if (v < -kEdgeTolerance || u + v > 1.0 + kEdgeTolerance) return std::nullopt;
    const double t = glm::dot(ac, q) / determinant;
    if (!(t >= 0.0)) return std::nullopt;
    return t;
}

std::optional<TriangleHit> searchTriangle(const SphericalMaps& maps, const Ray& ray,
                                          const std::function<void(const WalkedCell&)>& told) {
    // A little larger than the sphere, because its radius is rounded.
    const std::optional<Span> inside = throughSphere(ray, maps.sphere().radius * (1.0 + 1e-6));
    return inside ? searchTriangle(maps, ray, *inside, told) : std::nullopt;
}

std::optional<TriangleHit> searchTriangle(const SphericalMaps& maps, const Ray& ray, const Span& span,
                                          const std::function<void(const WalkedCell&)>& told) {
    const double foot = -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    std::optional<TriangleHit> nearest;
    for (WalkedCell& step : walkedCells(maps.grid(), ray, span)) {
        // The search goes on until the hit lies within the cells walked: a triangle of an earlier cell may be hit only in a later
        // one.
        if (nearest && nearest->t <= step.span.from) break;
        const uint32_t cell = maps.grid().number(step.cell);
        const double closest = std::clamp(foot, step.span.from, step.span.to);
        step.nearest = glm::length(ray.at(closest));
        step.farthest = std::max(glm::length(ray.at(step.span.from)), glm::length(ray.at(step.span.to)));
        const std::span<const uint32_t> triangles = maps.trianglesBetween(cell, step.nearest, step.farthest);
        step.tested = uint32_t(triangles.size());
        for (const uint32_t triangle : triangles) {
            const std::optional<double> t = hit(ray, maps.corners(triangle));
            if (!t || (nearest && *t >= nearest->t)) continue;
            nearest = TriangleHit{triangle, *t};
            step.hit = true;
        }
        if (told) told(step);
    }
    return nearest;
}

}  // namespace cullscope
