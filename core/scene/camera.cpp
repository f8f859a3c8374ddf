#include "core/scene/camera.h"

#include <cmath>

#include "core/base/error.h"

namespace cullscope {
namespace {

bool finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// The unit vector perpendicular to `forward` that is nearest to the right of `up`.
Vec3 rightOf(const Vec3& forward, const Vec3& up) {
    const Vec3 right = glm::cross(forward, up);
    const double length = glm::length(right);
    if (length > 1e-12 * glm::length(up)) return right / length;
    // `forward` is parallel to `up`: the axis with the smallest component of `forward` takes its place.
    const Vec3 size = glm::abs(forward);
    const Vec3 other = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0) : size.y <= size.z ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    return glm::normalize(glm::cross(forward, other));
}

}  // namespace

const char* projectionId(ProjectionKind projection) {
    return projection == ProjectionKind::Parallel ? "parallel" : "perspective";
}

std::optional<ProjectionKind> projectionFromId(std::string_view id) {
    for (const ProjectionKind projection : {ProjectionKind::Perspective, ProjectionKind::Parallel})
        if (id == projectionId(projection)) return projection;
    return std::nullopt;
}

double heightAtTarget(const Camera& camera) {
    if (camera.projection == ProjectionKind::Parallel) return camera.height;
    return 2.0 * glm::length(camera.target - camera.eye) * std::tan(camera.fovy.radians() / 2.0);
}

Camera inParallel(const Camera& camera) {
    Camera result = camera;
    result.height = heightAtTarget(camera);
    result.projection = ProjectionKind::Parallel;
    return result;
}

Camera inPerspective(const Camera& camera) {
    if (camera.projection == ProjectionKind::Perspective) return camera;
    Camera result = camera;
    const double distance = camera.height / 2.0 / std::tan(camera.fovy.radians() / 2.0);
    result.eye = camera.target - distance * glm::normalize(camera.target - camera.eye);
    result.projection = ProjectionKind::Perspective;
    result.height = Camera{}.height;
    return result;
}

void validate(const Camera& camera, const Viewport& viewport) {
    if (!finite(camera.eye) || !finite(camera.target) || !finite(camera.up))
        throwUsage(CULLSCOPE_TR("The camera's eye, target and up must be finite numbers."));
    if (!std::isfinite(glm::length(camera.target - camera.eye)) || !std::isfinite(glm::length(camera.up)))
        throwUsage(CULLSCOPE_TR("The camera's eye, target and up must be finite numbers."));
    if (!(glm::length(camera.target - camera.eye) > 0.0))
        throwUsage(CULLSCOPE_TR("The camera's eye and target are the same point: move one of them."));
    if (!(glm::length(camera.up) > 0.0)) throwUsage(CULLSCOPE_TR("The camera's up vector is zero: give it a direction."));
    if (!(camera.fovy > Angle::fromDegrees(0)) || !(camera.fovy < Angle::fromDegrees(180)))
        throwUsage(CULLSCOPE_TR("The field of view must lie between 0 and 180 degrees, not %1."),
                   {std::to_string(camera.fovy.degrees())});
    if (!(camera.nearDistance > 0.0) || !(camera.farDistance > camera.nearDistance) || !std::isfinite(camera.farDistance))
        throwUsage(CULLSCOPE_TR("The near distance must be above 0 and below the far distance (near %1, far %2)."),
                   {std::to_string(camera.nearDistance), std::to_string(camera.farDistance)});
    if (camera.projection == ProjectionKind::Parallel && !(camera.height > 0.0 && std::isfinite(camera.height)))
        throwUsage(CULLSCOPE_TR("The height of a parallel view must be a number above 0, not %1."),
                   {std::to_string(camera.height)});
    if (viewport.width < 1 || viewport.height < 1 || viewport.width > kMostPixels || viewport.height > kMostPixels)
        throwUsage(CULLSCOPE_TR("A picture is 1 to 16384 pixels wide and high, not %1x%2."),
                   {std::to_string(viewport.width), std::to_string(viewport.height)});
}

View::View(const Camera& camera, const Viewport& viewport) : m_camera(camera), m_viewport(viewport) {
    validate(camera, viewport);
    const Vec3 forward = glm::normalize(camera.target - camera.eye);
    const Vec3 right = rightOf(forward, glm::normalize(camera.up));
    const Vec3 up = glm::cross(right, forward);
    const double range = camera.farDistance - camera.nearDistance;
    if (camera.projection == ProjectionKind::Parallel) {
        const double halfHeight = camera.height / 2, halfWidth = halfHeight * viewport.width / viewport.height;
        m_frustum = makeParallelFrustum(forward, right, up, halfWidth, halfHeight, camera.nearDistance, camera.farDistance);
        // w is 1 everywhere, and reversed depth is (far − d) / (far − near).
        const Vec3 ofX = right / halfWidth, ofY = up / halfHeight, ofZ = forward / -range;
        for (int axis = 0; axis < 3; ++axis) m_clipFromEyeRelative[axis] = Vec4(ofX[axis], ofY[axis], ofZ[axis], 0.0);
        m_clipFromEyeRelative[3] = Vec4(0.0, 0.0, camera.farDistance / range, 1.0);
        return;
    }
    const double tanHalfHeight = std::tan(camera.fovy.radians() / 2);
    const double tanHalfWidth = tanHalfHeight * viewport.width / viewport.height;
    m_frustum = makeFrustum(forward, right, up, tanHalfWidth, tanHalfHeight, camera.nearDistance, camera.farDistance);

    // Reversed depth: z/w = (near·far/d − near) / (far − near), 1 at d = near and 0 at d = far.
    const Vec3 rowX = right / tanHalfWidth;
    const Vec3 rowY = up / tanHalfHeight;
    const Vec3 rowZ = forward * (-camera.nearDistance / range);
    for (int axis = 0; axis < 3; ++axis) m_clipFromEyeRelative[axis] = Vec4(rowX[axis], rowY[axis], rowZ[axis], forward[axis]);
    m_clipFromEyeRelative[3] = Vec4(0, 0, camera.nearDistance * (camera.farDistance / range), 0);
}

namespace {

Mat4 eyeRelative(const Mat4& worldFromMesh, const Vec3& meshOrigin, const Vec3& eye) {
    Mat4 matrix = worldFromMesh;
    // The linear part times the origin first: the large terms cancel against the eye while still in double.
    matrix[3] = Vec4(Vec3(worldFromMesh[3]) - eye + Mat3(worldFromMesh) * meshOrigin, 1.0);
    return matrix;
}

}  // namespace

Mat4f View::clipFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const {
    return Mat4f(m_clipFromEyeRelative * eyeRelative(worldFromMesh, meshOrigin, m_camera.eye));
}

Mat4f View::sightFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const {
    if (m_frustum.parallel()) {
        Mat4f same(0.0f);
        same[3] = Mat4f::col_type(Vec3f(m_frustum.forward), 1.0f);
        return same;
    }
    return Mat4f(eyeRelative(worldFromMesh, meshOrigin, m_camera.eye));
}

Vec3 View::direction(double x, double y) const {
    const double across = (2.0 * x / m_viewport.width - 1.0) * m_frustum.tanHalfWidth;
    const double upward = (2.0 * y / m_viewport.height - 1.0) * m_frustum.tanHalfHeight;
    return m_frustum.forward + m_frustum.right * across + m_frustum.up * upward;
}

Vec3 View::sightOrigin(double x, double y) const {
    return m_frustum.right * ((2.0 * x / m_viewport.width - 1.0) * m_frustum.halfWidth) +
           m_frustum.up * ((2.0 * y / m_viewport.height - 1.0) * m_frustum.halfHeight);
}

double View::depthOfPlane(const Vec3& normal, double offset, double x, double y) const {
    // A point at distance s on the line of sight lies in the plane where normal·(origin + s direction) = offset.
    const double along = glm::dot(normal, direction(x, y));
    if (m_frustum.parallel()) return depthFromDistance((offset - glm::dot(normal, sightOrigin(x, y))) / along);
    // In perspective the depth is affine in 1 / s.
    const double n = m_camera.nearDistance, f = m_camera.farDistance, inverse = along / offset;
    return n * (f * inverse - 1.0) / (f - n);
}

double View::distanceFromDepth(double depth) const {
    const double n = m_camera.nearDistance;
    const double f = m_camera.farDistance;
    return m_frustum.parallel() ? f - depth * (f - n) : n * f / (depth * (f - n) + n);
}

double View::depthFromDistance(double forwardDistance) const {
    const double n = m_camera.nearDistance;
    const double f = m_camera.farDistance;
    return m_frustum.parallel() ? (f - forwardDistance) / (f - n) : (n * f / forwardDistance - n) / (f - n);
}

}  // namespace cullscope
