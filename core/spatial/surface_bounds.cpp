#include "core/spatial/surface_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/geometry/bounds.h"

namespace cullscope {
namespace {

// cos 84°: a wider cone is hardly ever back-facing as a whole, and its test loses its precision.
constexpr double kWidestConeCosine = 0.104528;
// Bound on the rounding of values stored as float.
constexpr double kFloatError = 1e-6;
constexpr float kNoCone = 2.0f;

Vec3f roundedDown(const Vec3& v) {
    Vec3f result(v);
    for (int i = 0; i < 3; ++i)
        if (double(result[i]) > v[i]) result[i] = std::nextafter(result[i], -std::numeric_limits<float>::infinity());
    return result;
}
float roundedUp(double value) {
    const auto result = float(value);
    return double(result) < value ? std::nextafter(result, std::numeric_limits<float>::infinity()) : result;
}
Vec3f roundedUp(const Vec3& v) { return {roundedUp(v.x), roundedUp(v.y), roundedUp(v.z)}; }

/// The orientation of a triangle.
struct Facet {
    Vec3 normal{0.0};     ///< unit; the null vector where the triangle has no area
    double height = 0.0;  ///< smallest altitude; infinite where two corners coincide, because such a triangle is never drawn
};

Facet facetOf(const TriangleCorners& corners) {
    const auto& [a, b, c] = corners;
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (a == b || b == c || c == a) return {Vec3(0.0), kInfinity};
    const Vec3 normal = glm::cross(b - a, c - a);
    const double area = glm::length(normal);
    const double longest = std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (!(area > 0.0)) return {};
    return {normal / area, area / longest};
}

/// Sets the cone of bounds from its axis and the cosine of its half-angle.
void setCone(SurfaceBounds& bounds, const Vec3& axis, double cosine) {
    cosine -= kFloatError;
    bounds.coneAxis = Vec3f(axis);
    bounds.coneCosine = cosine < kWidestConeCosine ? kNoCone : float(cosine);
    bounds.coneSine = float(std::sqrt(std::max(0.0, 1.0 - cosine * cosine)) + kFloatError);
}

/// The largest n · v over all unit vectors n in the cone.
double largestAlong(const SurfaceBounds& bounds, const Vec3& v) {
    const double length = glm::length(v), along = glm::dot(Vec3(bounds.coneAxis), v);
    if (along >= length * bounds.coneCosine) return length;
    return along * bounds.coneCosine + std::sqrt(std::max(0.0, length * length - along * along)) * bounds.coneSine;
}

}  // namespace

SurfaceBounds boundsOf(std::span<const TriangleCorners> triangles) {
    SurfaceBounds bounds;
    Box3 box;
    Vec3 sum(0.0);
    double height = std::numeric_limits<double>::infinity();
    std::vector<std::pair<Vec3, double>> planes;  // unit normal, and its dot product with the triangle's points
    for (const TriangleCorners& points : triangles) {
        for (const Vec3& point : points) box.add(point);
        const Facet facet = facetOf(points);
        height = std::min(height, facet.height);
        if (facet.normal == Vec3(0.0)) continue;
        planes.emplace_back(facet.normal, glm::dot(facet.normal, points[0]));
        sum += facet.normal;
    }
    bounds.low = roundedDown(box.min);
    bounds.high = roundedUp(box.max);
    bounds.leastHeight = -roundedUp(-height);
    bounds.coneCosine = planes.empty() ? 1.0f : kNoCone;
    if (glm::length(sum) < 1e-3) return bounds;
    const Vec3 axis = glm::normalize(sum), middle = bounds.middle();
    double cosine = 1.0, margin = -std::numeric_limits<double>::infinity();
    for (const auto& [normal, offset] : planes) {
        cosine = std::min(cosine, glm::dot(normal, axis));
        margin = std::max(margin, glm::dot(normal, middle) - offset);
    }
    setCone(bounds, axis, cosine);
    bounds.planeMargin = roundedUp(margin + kFloatError * glm::length(box.halfExtent()));
    return bounds;
}

SurfaceBounds boundsOfParts(const SurfaceNodes& nodes, const SurfaceNode& node) {
    SurfaceBounds bounds;
    Vec3 sum(0.0);
    bool cones = true, normals = false;
    bounds.low = nodes[node.firstChild].low;
    bounds.high = nodes[node.firstChild].high;
    bounds.leastHeight = nodes[node.firstChild].leastHeight;
    for (uint32_t i = 0; i < node.childCount; ++i) {
        const SurfaceNode& child = nodes[node.firstChild + i];
        bounds.low = glm::min(bounds.low, child.low);
        bounds.high = glm::max(bounds.high, child.high);
        bounds.leastHeight = std::min(bounds.leastHeight, child.leastHeight);
        cones = cones && child.hasCone();
        normals = normals || child.hasNormals();
        sum += double(child.count) * Vec3(child.coneAxis);
    }
    // Children with opposite normals have no common axis.
    bounds.coneCosine = cones && !normals ? 1.0f : kNoCone;
    if (!cones || glm::length(sum) < 1e-3) return bounds;
    const Vec3 axis = glm::normalize(sum), middle = bounds.middle();
    double angle = 0.0, margin = -std::numeric_limits<double>::infinity();
    for (uint32_t i = 0; i < node.childCount; ++i) {
        const SurfaceNode& child = nodes[node.firstChild + i];
        if (!child.hasNormals()) continue;
        // Computed from the chord, which keeps its precision for small angles; axes stored as float are not exactly of unit
        // length.
        const double chord = glm::length(axis - glm::normalize(Vec3(child.coneAxis)));
        const double apart = 2.0 * std::asin(std::min(1.0, 0.5 * chord)) + kFloatError;
        angle = std::max(angle, apart + std::acos(std::min(1.0, double(child.coneCosine))));
        margin = std::max(margin, child.planeMargin + largestAlong(child, middle - child.middle()));
    }
    setCone(bounds, axis, angle < 1.5 ? std::cos(angle) : -1.0);
    bounds.planeMargin = roundedUp(margin + kFloatError * glm::length(Vec3(bounds.high) - Vec3(bounds.low)));
    return bounds;
}

double meanShareFacingAway(const SurfaceNodes& nodes) {
    if (nodes.size() == 0 || nodes[0].count == 0) return 0.0;
    double away = 0.0;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].leaf() && nodes[i].hasCone()) away += nodes[i].count * (1.0 - double(nodes[i].coneSine)) / 2.0;
    return away / nodes[0].count;
}

bool holdsFor(const SurfaceBounds& bounds, const TriangleCorners& triangle) {
    const Vec3 low(bounds.low), high(bounds.high);
    for (const Vec3& corner : triangle)
        if (!glm::all(glm::lessThanEqual(low, corner)) || !glm::all(glm::lessThanEqual(corner, high))) return false;
    const Facet facet = facetOf(triangle);
    if (bounds.leastHeight > facet.height) return false;
    if (!bounds.hasCone() || facet.normal == Vec3(0.0)) return true;
    // Of the axis as it is stored, which is not exactly of unit length.
    const double along = glm::dot(facet.normal, glm::normalize(Vec3(bounds.coneAxis)));
    return bounds.hasNormals() && along >= double(bounds.coneCosine) &&
           glm::dot(facet.normal, bounds.middle() - triangle[0]) <= double(bounds.planeMargin);
}

SurfaceBounds widened(const SurfaceBounds& bounds, const TriangleCorners& triangle) {
    const SurfaceBounds own = boundsOf(std::span(&triangle, 1));
    SurfaceBounds result;
    result.low = glm::min(bounds.low, own.low);
    result.high = glm::max(bounds.high, own.high);
    result.leastHeight = std::min(bounds.leastHeight, own.leastHeight);
    return result;
}

}  // namespace cullscope
