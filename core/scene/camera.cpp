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
    if (viewport.width < 1 || viewport.height < 1 || viewport.width > kMostPixels || viewport.height > kMostPixels)
        throwUsage(CULLSCOPE_TR("A picture is 1 to 16384 pixels wide and high, not %1x%2."),
                   {std::to_string(viewport.width), std::to_string(viewport.height)});
}

View::View(const Camera& camera, const Viewport& viewport) : m_camera(camera), m_viewport(viewport) {
    validate(camera, viewport);
    const Vec3 forward = glm::normalize(camera.target - camera.eye);
    const Vec3 right = rightOf(forward, glm::normalize(camera.up));
    const Vec3 up = glm::cross(right, forward);
    const double tanHalfHeight = std::tan(camera.fovy.radians() / 2);
    const double tanHalfWidth = tanHalfHeight * viewport.width / viewport.height;
    m_frustum = makeFrustum(forward, right, up, tanHalfWidth, tanHalfHeight, camera.nearDistance, camera.farDistance);

    // Reversed depth: z/w = (near·far/d − near) / (far − near), 1 at d = near and 0 at d = far.
    const double range = camera.farDistance - camera.nearDistance;
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

Mat4f View::eyeRelativeFromPositions(const Mat4& worldFromMesh, const Vec3& meshOrigin) const {
    return Mat4f(eyeRelative(worldFromMesh, meshOrigin, m_camera.eye));
}

Vec3 View::direction(double x, double y) const {
    const double across = (2.0 * x / m_viewport.width - 1.0) * m_frustum.tanHalfWidth;
    const double upward = (2.0 * y / m_viewport.height - 1.0) * m_frustum.tanHalfHeight;
    return m_frustum.forward + m_frustum.right * across + m_frustum.up * upward;
}

double View::distanceFromDepth(double depth) const {
    const double n = m_camera.nearDistance;
    const double f = m_camera.farDistance;
    return n * f / (depth * (f - n) + n);
}

double View::depthFromDistance(double forwardDistance) const {
    const double n = m_camera.nearDistance;
    const double f = m_camera.farDistance;
    return (n * f / forwardDistance - n) / (f - n);
}

}  // namespace cullscope
