#include "core/spatial/screen_polygon.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/clip_polygon.h"

namespace cullscope {
namespace {

/// Differences of inverse distances below this share of them are rounding; a float depth resolves 2^-23.
constexpr double kSameDistance = 0x1p-32;

/// Corners that are nearer to each other, in pixels, are one: between them rounding decides where an edge points.
constexpr double kSameCorner = 1e-6;

double turned(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// By how much two polygons overlap along the normals of the first one's edges, at least: pixels.
double leastReach(const ScreenPolygon& edges, const ScreenPolygon& other) {
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < edges.points.size(); ++i) {
        const Vec2 from = edges.points[i], along = edges.points[(i + 1) % edges.points.size()] - from;
        const double length = glm::length(along);
        if (!(length > 0.0)) continue;
        double reach = -std::numeric_limits<double>::infinity();
        for (const Vec2& point : other.points) reach = std::max(reach, turned(along, point - from) / length);
        least = std::min(least, reach);
    }
    return least;
}

}  // namespace

ScreenProjection::ScreenProjection(const View& view)
    : m_forward(view.frustum().forward),
      m_right(view.frustum().right * (0.5 * view.viewport().width / view.frustum().tanHalfWidth)),
      m_up(view.frustum().up * (0.5 * view.viewport().height / view.frustum().tanHalfHeight)),
      m_near(view.frustum().nearDistance),
      m_width(view.viewport().width),
      m_height(view.viewport().height) {}

ScreenPolygon ScreenProjection::project(const std::vector<Vec3>& corners, const Vec3& normal) const {
    ScreenPolygon result;
    std::vector<Vec3> polygon, buffer;
    for (const Vec3& corner : corners)
        polygon.emplace_back(glm::dot(m_right, corner), glm::dot(m_up, corner), glm::dot(m_forward, corner));
    clipPolygon(polygon, buffer, [&](const Vec3& p) { return p.z - m_near; });
    // The sides of the picture, as planes through the eye.
    for (const double sign : {-1.0, 1.0}) {
        clipPolygon(polygon, buffer, [&](const Vec3& p) { return 0.5 * m_width * p.z - sign * p.x; });
        clipPolygon(polygon, buffer, [&](const Vec3& p) { return 0.5 * m_height * p.z - sign * p.y; });
    }
    if (polygon.size() < 3) return result;
    result.near = result.far = polygon.front().z;
    result.x0 = result.y0 = std::numeric_limits<double>::infinity();
    result.x1 = result.y1 = -std::numeric_limits<double>::infinity();
    for (const Vec3& p : polygon) {
        const Vec2 point(p.x / p.z + 0.5 * m_width, p.y / p.z + 0.5 * m_height);
        result.near = std::min(result.near, p.z);
        result.far = std::max(result.far, p.z);
        result.x0 = std::min(result.x0, point.x);
        result.x1 = std::max(result.x1, point.x);
        result.y0 = std::min(result.y0, point.y);
        result.y1 = std::max(result.y1, point.y);
        if (result.points.empty() || glm::length(point - result.points.back()) > kSameCorner) result.points.push_back(point);
    }
    while (result.points.size() > 1 && glm::length(result.points.front() - result.points.back()) <= kSameCorner)
        result.points.pop_back();
    if (result.points.size() < 3) return {};
    double area = 0.0;
    for (size_t i = 2; i < result.points.size(); ++i)
        area += turned(result.points[i - 1] - result.points[0], result.points[i] - result.points[0]);
    if (area < 0.0) std::ranges::reverse(result.points);
    // The plane n·p = n·corner, with p = s (forward + right x' + up y'): 1/s = n·(forward + right x' + up y') / n·corner.
    double offset = 0.0;
    for (const Vec3& corner : corners) offset += glm::dot(normal, corner) / double(corners.size());
    const Vec3 right = m_right / glm::dot(m_right, m_right), up = m_up / glm::dot(m_up, m_up);
    result.inverse.x = glm::dot(normal, right) / offset;
    result.inverse.y = glm::dot(normal, up) / offset;
    result.inverse.z =
        glm::dot(normal, m_forward) / offset - 0.5 * m_width * result.inverse.x - 0.5 * m_height * result.inverse.y;
    return result;
}

Overlap overlapOf(const ScreenPolygon& first, const ScreenPolygon& second) {
    Overlap result;
    result.thickness = std::min(leastReach(first, second), leastReach(second, first));
    if (result.thickness <= Overlap::kApart) return result;
    std::vector<Vec2> polygon = first.points, buffer;
    for (size_t i = 0; i < second.points.size(); ++i) {
        const Vec2 from = second.points[i], along = second.points[(i + 1) % second.points.size()] - from;
        clipPolygon(polygon, buffer, [&](const Vec2& point) { return turned(along, point - from); });
    }
    for (const Vec2& point : polygon) {
        const double one = first.inverseAt(point), other = second.inverseAt(point);
        const double size = std::max(std::abs(one), std::abs(other)), before = one - other;
        const double rounded = std::abs(before) > kSameDistance * size ? before : 0.0;
        result.leastBefore = std::min(result.leastBefore, rounded);
        result.mostBefore = std::max(result.mostBefore, rounded);
    }
    return result;
}

}  // namespace cullscope
