#include "tests/support/pixel_edges.h"

#include <cmath>

namespace cullscope::test {
namespace {

using Real = long double;
using Axis = std::array<Real, 3>;

Axis cross(const Axis& a, const Axis& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Axis unit(const Axis& a) {
    const Real length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

}  // namespace

Real PixelEdges::toSegment(const Pixel& p, const Pixel& a, const Pixel& b) {
    const Real dx = b.x - a.x;
    const Real dy = b.y - a.y;
    const Real squared = dx * dx + dy * dy;
    const Real t = squared > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / squared, Real(0), Real(1)) : Real(0);
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

PixelEdges::PixelEdges(const Scene& scene, const Camera& camera, const Viewport& viewport)
    : m_scene(scene), m_camera(camera), m_viewport(viewport) {
    Axis forward, up;
    for (int axis = 0; axis < 3; ++axis) {
        forward[size_t(axis)] = Real(camera.target[axis]) - Real(camera.eye[axis]);
        up[size_t(axis)] = camera.up[axis];
    }
    forward = unit(forward);
    const Axis right = unit(cross(forward, up));
    m_axes = {right, cross(right, forward), forward};
    m_tanHalfHeight = std::tan(Real(camera.fovy.radians()) / 2);
    if (camera.projection == ProjectionKind::Parallel) m_tanHalfHeight = Real(camera.height) / 2;
    m_tanHalfWidth = m_tanHalfHeight * viewport.width / viewport.height;
}

PixelEdges::Point PixelEdges::fromEye(const Vec3& origin, const Mat3& linear, const Vec3& translation,
                                      const Vec3f& position) const {
    Axis point;
    for (int row = 0; row < 3; ++row) {
        Real sum = Real(translation[row]) - Real(m_camera.eye[row]);
        for (int axis = 0; axis < 3; ++axis) sum += Real(linear[axis][row]) * (Real(origin[axis]) + Real(position[axis]));
        point[size_t(row)] = sum;
    }
    return {dot(point, m_axes[0]), dot(point, m_axes[1]), dot(point, m_axes[2])};
}

std::vector<PixelEdges::Pixel> PixelEdges::cornersOf(uint64_t triangle) const {
    const size_t instance = m_scene.instanceOf(triangle);
    const TriangleMesh& mesh = m_scene.meshOf(instance);
    const Mat4& place = m_scene.instances()[instance].worldFromMesh;
    const size_t first = 3 * size_t(triangle - m_scene.firstTriangle(instance));
    std::vector<Point> polygon;
    for (size_t i = 0; i < 3; ++i)
        polygon.push_back(fromEye(mesh.origin(), Mat3(place), Vec3(place[3]), mesh.positions()[mesh.indices()[first + i]]));

    for (const bool nearPlane : {true, false}) {
        const Real limit = nearPlane ? m_camera.nearDistance : m_camera.farDistance;
        const auto distance = [&](const Point& p) { return nearPlane ? p.forward - limit : limit - p.forward; };
        std::vector<Point> kept;
        for (size_t i = 0; i < polygon.size(); ++i) {
            const Point& a = polygon[i];
            const Point& b = polygon[(i + 1) % polygon.size()];
            if (distance(a) >= 0) kept.push_back(a);
            if ((distance(a) < 0) == (distance(b) < 0)) continue;
            const Real t = distance(a) / (distance(a) - distance(b));
            kept.push_back({a.right + t * (b.right - a.right), a.up + t * (b.up - a.up), limit});
        }
        polygon = std::move(kept);
    }

    std::vector<Pixel> corners;
    for (const Point& p : polygon) {
        const Real by = m_camera.projection == ProjectionKind::Parallel ? Real(1) : p.forward;
        corners.push_back({(p.right / (by * m_tanHalfWidth) + 1) * m_viewport.width / 2,
                           (p.up / (by * m_tanHalfHeight) + 1) * m_viewport.height / 2});
    }
    return corners;
}

double PixelEdges::toEdgeOf(uint64_t triangle, size_t pixel) const {
    const std::vector<Pixel> corners = cornersOf(triangle);
    const auto width = static_cast<size_t>(m_viewport.width);
    const Pixel centre{Real(pixel % width) + Real(0.5), Real(pixel / width) + Real(0.5)};
    Real nearest = std::numeric_limits<Real>::infinity();
    for (size_t i = 0; i < corners.size(); ++i)
        nearest = std::min(nearest, toSegment(centre, corners[i], corners[(i + 1) % corners.size()]));
    return static_cast<double>(nearest);
}

double PixelEdges::inscribedRadius(uint64_t triangle) const {
    const std::vector<Pixel> corners = cornersOf(triangle);
    Real doubleArea = 0, perimeter = 0;
    for (size_t i = 0; i < corners.size(); ++i) {
        const Pixel& a = corners[i];
        const Pixel& b = corners[(i + 1) % corners.size()];
        doubleArea += (a.x - corners[0].x) * (b.y - corners[0].y) - (b.x - corners[0].x) * (a.y - corners[0].y);
        perimeter += std::hypot(b.x - a.x, b.y - a.y);
    }
    return perimeter > 0 ? static_cast<double>(std::abs(doubleArea) / perimeter) : 0.0;
}

}  // namespace cullscope::test
