#include "core/geometry/separation.h"

#include <cmath>

namespace cullscope {
namespace {

/// An axis with a smaller squared length is skipped: its products might underflow, and no bound on their rounding would hold.
constexpr double kLeastSquare = 1e-200;

double sumOfSizes(const Vec3& v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); }

/// A frustum in camera coordinates (along right, up, forward), where four numbers describe it. A point's coordinates are its dot
/// products with the basis vectors, as for the planes and the clip matrix; the basis need not be exactly orthonormal.
class CameraFrustum {
public:
    /// The far distance is cut at `farthest`, beyond which no point of the object lies: a far plane at 1e9 would give a rounding
    /// of 1e-7.
    CameraFrustum(const Frustum& frustum, double farthest)
        : m_right(frustum.right),
          m_up(frustum.up),
          m_forward(frustum.forward),
          m_tanHalfWidth(frustum.tanHalfWidth),
          m_tanHalfHeight(frustum.tanHalfHeight),
          m_halfWidth(frustum.halfWidth),
          m_halfHeight(frustum.halfHeight),
          m_near(frustum.leastDistance()),
          m_far(std::max(m_near, std::min(frustum.mostDistance(), farthest))) {}

    [[nodiscard]] Vec3 coordinates(const Vec3& eyeRelative) const {
        return {glm::dot(m_right, eyeRelative), glm::dot(m_up, eyeRelative), glm::dot(m_forward, eyeRelative)};
    }
    [[nodiscard]] Vec3 world(const Vec3& camera) const { return m_right * camera.x + m_up * camera.y + m_forward * camera.z; }

    /// Whether the interval centre ± reach lies outside the frustum's interval along `axis` (camera coordinates) by more than
    /// `room`.
    [[nodiscard]] bool apart(const Vec3& axis, double centre, double reach, double room) const {
        const double aside = m_tanHalfWidth * std::abs(axis.x) + m_tanHalfHeight * std::abs(axis.y);
        const double most = axis.z + aside;
        const double least = axis.z - aside;
        const double atEye = m_halfWidth * std::abs(axis.x) + m_halfHeight * std::abs(axis.y);
        return centre - reach - (atEye + most * (most > 0.0 ? m_far : m_near)) > room ||
               least * (least < 0.0 ? m_far : m_near) - atEye - (centre + reach) > room;
    }

    /// The frustum's point nearest to `from`, both in camera coordinates.
    [[nodiscard]] Vec3 nearestPoint(const Vec3& from) const {
        const double x = std::abs(from.x);
        const double y = std::abs(from.y);
        const double depth = std::min(std::max(nearestDepth(x - m_halfWidth, y - m_halfHeight, from.z), m_near), m_far);
        return {std::copysign(std::min(x, m_halfWidth + m_tanHalfWidth * depth), from.x),
                std::copysign(std::min(y, m_halfHeight + m_tanHalfHeight * depth), from.y), depth};
    }

    /// Directions of the edges; the near and far rectangles' edges are parallel.
    [[nodiscard]] std::array<Vec3, 6> edges() const {
        const double w = m_tanHalfWidth;
        const double h = m_tanHalfHeight;
        return {Vec3(w, h, 1), Vec3(-w, h, 1), Vec3(w, -h, 1), Vec3(-w, -h, 1), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    }

private:
    /// The depth d at which max(0, x − w·d)² + max(0, y − h·d)² + (z − d)² is smallest. The function is convex in d and quadratic
    /// in four pieces; the minimum of each is tried. x and y count from the sides' places at the eye. This depth alone decides
    /// whether the nearest point lies on a face, an edge or a corner.
    [[nodiscard]] double nearestDepth(double x, double y, double z) const {
        const double w = m_tanHalfWidth;
        const double h = m_tanHalfHeight;
        if (x <= w * z && y <= h * z) return z;
        const double besideWidth = (z + w * x) / (1.0 + w * w);
        if (x >= w * besideWidth && y <= h * besideWidth) return besideWidth;
        const double besideHeight = (z + h * y) / (1.0 + h * h);
        if (x <= w * besideHeight && y >= h * besideHeight) return besideHeight;
        return (z + w * x + h * y) / (1.0 + w * w + h * h);
    }

    Vec3 m_right, m_up, m_forward;
    double m_tanHalfWidth, m_tanHalfHeight, m_halfWidth, m_halfHeight, m_near, m_far;
};

/// A parallelepiped in camera coordinates.
struct CameraBox {
    Vec3 centre;
    std::array<Vec3, 3> halves;  ///< half edges
    std::array<Vec3, 3> edges;   ///< directions of the edges, about unit length; 0 where unknown
    double room;                 ///< how far beyond the frustum the box must lie, for an axis of unit length
};

bool apartAlong(const Vec3& axis, const CameraFrustum& frustum, const CameraBox& box) {
    const double square = glm::dot(axis, axis);
    if (!(square > kLeastSquare)) return false;
    const double reach = std::abs(glm::dot(axis, box.halves[0])) + std::abs(glm::dot(axis, box.halves[1])) +
                         std::abs(glm::dot(axis, box.halves[2]));
    return frustum.apart(axis, glm::dot(axis, box.centre), reach, box.room * std::sqrt(square));
}

bool separatedBox(const CameraFrustum& frustum, const CameraBox& box) {
    for (size_t i = 0; i < 3; ++i)
        if (apartAlong(glm::cross(box.edges[i], box.edges[(i + 1) % 3]), frustum, box)) return true;
    for (const Vec3& frustumEdge : frustum.edges())
        for (const Vec3& boxEdge : box.edges)
            if (apartAlong(glm::cross(frustumEdge, boxEdge), frustum, box)) return true;
    return false;
}

/// The bound r on all rounding, derived in the header's first comment.
double rounding(double farthest) { return farthest * 0x1p-47; }

double farthestOf(const EyeBox& box) { return sumOfSizes(box.centre) + sumOfSizes(box.halfExtent); }

CameraBox inCamera(const Frustum& frustum, const CameraFrustum& camera, const EyeBox& box, double margin) {
    CameraBox result;
    result.centre = camera.coordinates(box.centre);
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 edge(frustum.right[axis], frustum.up[axis], frustum.forward[axis]);
        result.edges[size_t(axis)] = edge;
        result.halves[size_t(axis)] = edge * box.halfExtent[axis];
    }
    result.room = margin + rounding(farthestOf(box));
    return result;
}

}  // namespace

bool separated(const Frustum& frustum, const EyeBox& box, double margin) {
    const CameraFrustum camera(frustum, farthestOf(box));
    return separatedBox(camera, inCamera(frustum, camera, box, margin));
}

bool separated(const Frustum& frustum, const OrientedBox& box, double margin) {
    double farthest = sumOfSizes(box.centre) + box.room;
    for (const Vec3& axis : box.axes) farthest += sumOfSizes(axis);
    const CameraFrustum camera(frustum, farthest);
    CameraBox result;
    result.centre = camera.coordinates(box.centre);
    for (size_t axis = 0; axis < 3; ++axis) {
        const Vec3 half = camera.coordinates(box.axes[axis]);
        const double length = glm::length(half);
        result.halves[axis] = half;
        result.edges[axis] = length > 0.0 ? half / length : Vec3(0.0);
    }
    result.room = margin + box.room + rounding(farthest);
    return separatedBox(camera, result);
}

bool separated(const Frustum& frustum, const Sphere& eyeSphere, double margin) {
    const double farthest = sumOfSizes(eyeSphere.centre) + eyeSphere.radius;
    const CameraFrustum camera(frustum, farthest);
    const Vec3 centre = camera.coordinates(eyeSphere.centre);
    const Vec3 direct = centre - camera.nearestPoint(centre);
    const double x = std::copysign(frustum.tanHalfWidth, centre.x);
    const double y = std::copysign(frustum.tanHalfHeight, centre.y);
    // The direction from the nearest point to the centre is inaccurate by the rounding of both, more so with a wide view. Where
    // the nearest point lies on a side, or on the edge between two, the axis is perpendicular to it, so these axes are tried too.
    const Vec3 ray(x, y, 1.0);
    for (const Vec3& axis : {direct, Vec3(std::copysign(1.0, x), 0.0, -frustum.tanHalfWidth),
                             Vec3(0.0, std::copysign(1.0, y), -frustum.tanHalfHeight),
                             direct - ray * (glm::dot(direct, ray) / glm::dot(ray, ray))}) {
        if (!(glm::dot(axis, axis) > kLeastSquare)) continue;
        // The sphere is tested with the axis in world coordinates, where it is a sphere even if the basis is not exactly
        // orthonormal.
        const double length = glm::length(camera.world(axis));
        if (camera.apart(axis, glm::dot(axis, centre), eyeSphere.radius * length, (margin + rounding(farthest)) * length))
            return true;
    }
    return false;
}

bool meetsNearRectangle(const Frustum& frustum, const EyeBox& box, double margin) {
    Frustum rectangle = frustum;
    // Of a parallel view as thick as the rounding of its depth.
    rectangle.nearDistance = frustum.leastDistance();
    rectangle.farDistance = 2.0 * frustum.nearDistance - frustum.leastDistance();
    const EyeBox grown{box.centre, box.halfExtent + margin};
    const CameraFrustum camera(rectangle, farthestOf(grown));
    const CameraBox object = inCamera(rectangle, camera, grown, 0.0);
    return !apartAlong(Vec3(0, 0, 1), camera, object) && !separatedBox(camera, object);
}

}  // namespace cullscope
