#include "core/scene/camera_moves.h"

#include <algorithm>
#include <cmath>

#include "core/scene/camera_path.h"

namespace cullscope {

namespace {

constexpr double kMaximumElevation = 89.5;  // degrees: a turntable does not turn over the pole
constexpr double kClosest = 1e-4;           // of the scene's radius
constexpr double kReachBeyond = 0.05;       // of the scene's radius: distance of the target after the eye has passed through a
                                            // point
constexpr double kFarthest = 1e4;           // of the scene's radius
constexpr double kNearestNearPlane = 1e-7;  // of the far plane: the smallest ratio at which a float depth buffer still separates
                                            // depths
constexpr double kFramingMargin = 1.04;

/// The horizontal axes from which azimuth is measured: azimuth 0 looks from `front`, 90° from `side`.
struct Turntable {
    Vec3 up, front, side;
};

Turntable turntable(UpAxis up) {
    if (up == UpAxis::Y) return {Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0)};
    return {Vec3(0, 0, 1), Vec3(0, -1, 0), Vec3(1, 0, 0)};
}

/// `offset` rotated by azimuth about the up axis and by elevation towards it; same length.
Vec3 turnedOffset(const Vec3& offset, UpAxis up, Angle azimuth, Angle elevation) {
    const Turntable table = turntable(up);
    const double length = glm::length(offset);
    const double height = std::clamp(glm::dot(offset, table.up) / length, -1.0, 1.0);
    const double limit = Angle::fromDegrees(kMaximumElevation).radians();
    const double newElevation = std::clamp(std::asin(height) + elevation.radians(), -limit, limit);
    const double newAzimuth = std::atan2(glm::dot(offset, table.side), glm::dot(offset, table.front)) + azimuth.radians();
    const Vec3 horizontal = std::cos(newAzimuth) * table.front + std::sin(newAzimuth) * table.side;
    return length * (std::sin(newElevation) * table.up + std::cos(newElevation) * horizontal);
}

const Angle kObserverAzimuth = Angle::fromDegrees(75.0);
const Angle kObserverElevation = Angle::fromDegrees(12.0);
constexpr double kBeyondScene = 1.01;  // of the distance to its far side
constexpr double kWidestFramed = 1.5;  // the tangent of half an angle of view

}  // namespace

Vec3 axisVector(UpAxis up) { return turntable(up).up; }

Camera turned(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation) {
    Camera result = camera;
    result.up = axisVector(up);
    result.eye = camera.target + turnedOffset(camera.eye - camera.target, up, azimuth, elevation);
    return result;
}

Camera turnedAbout(const Camera& camera, UpAxis up, const Vec3& pivot, Angle azimuth, Angle elevation) {
    const Camera result = turned(camera, up, azimuth, elevation);
    // Both cameras stand upright: their right sides are horizontal, and the turn takes one's axes to the other's.
    const auto axes = [](const Camera& upright) {
        const Vec3 back = glm::normalize(upright.eye - upright.target), right = glm::cross(upright.up, back);
        return Mat3(glm::normalize(right), glm::cross(back, glm::normalize(right)), back);
    };
    const Mat3 turn = axes(result) * glm::transpose(axes(turned(camera, up, {}, {})));
    Camera about = result;
    about.eye = pivot + turn * (turned(camera, up, {}, {}).eye - pivot);
    about.target = pivot + turn * (camera.target - pivot);
    return about;
}

Camera seenFrom(const Camera& camera, UpAxis up, const Vec3& direction) {
    const double height = glm::dot(glm::normalize(direction), axisVector(up));
    // At the poles the azimuth is not defined by the direction: the present azimuth is kept.
    if (std::abs(height) > std::sin(Angle::fromDegrees(kMaximumElevation).radians()))
        return turned(camera, up, {}, Angle::fromDegrees(height > 0.0 ? 180.0 : -180.0));
    Camera result = camera;
    result.up = axisVector(up);
    result.eye = camera.target + glm::length(camera.eye - camera.target) * glm::normalize(direction);
    return result;
}

Camera looked(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation) {
    if (camera.projection == ProjectionKind::Parallel)
        return turned(camera, up, azimuth, Angle::fromRadians(-elevation.radians()));
    Camera result = camera;
    result.up = axisVector(up);
    result.target = camera.eye + turnedOffset(camera.target - camera.eye, up, azimuth, elevation);
    return result;
}

Camera panned(const View& view, double distance, const Vec2& from, const Vec2& to) {
    Camera result = view.camera();
    const auto at = [&](const Vec2& pixel) {
        return view.sightOrigin(pixel.x, pixel.y) + distance * view.direction(pixel.x, pixel.y);
    };
    const Vec3 shift = at(from) - at(to);
    result.eye += shift;
    result.target += shift;
    return result;
}

Camera zoomed(const Camera& camera, const Vec3& point, double factor, double sceneRadius) {
    Camera result = camera;
    const Vec3 offset = camera.eye - point;
    const double distance = glm::length(offset);
    const double reach = glm::length(camera.eye - camera.target);
    const double closest = kClosest * sceneRadius;
    if (camera.projection == ProjectionKind::Parallel) {
        result.height = std::clamp(factor * camera.height, closest, kFarthest * sceneRadius);
        const Vec3 forward = (camera.target - camera.eye) / reach;
        const Vec3 aside = -offset - glm::dot(-offset, forward) * forward;
        const Vec3 shift = (1.0 - result.height / camera.height) * aside;
        result.eye += shift;
        result.target += shift;
        return result;
    }
    if (factor > 1.0 && distance * factor > kFarthest * sceneRadius) return result;
    if (factor < 1.0 && (distance * factor < closest || reach * factor < closest)) {
        const Vec3 forward = (camera.target - camera.eye) / reach;
        const bool ahead = distance > 0.0 && glm::dot(-offset, forward) > 0.0;
        const double next = kReachBeyond * sceneRadius;
        const Vec3 step = ahead ? std::max(distance, closest) / distance * -offset : next * forward;
        result.eye += (1.0 - factor) * step;
        result.target = result.eye + next * forward;
        return result;
    }
    result.eye = point + factor * offset;
    result.target = point + factor * (camera.target - point);
    return result;
}

Camera flown(const View& view, const Vec3& step) {
    Camera result = view.camera();
    const Frustum& frustum = view.frustum();
    const Vec3 shift = step.x * frustum.right + step.y * frustum.up + step.z * frustum.forward;
    result.eye += shift;
    result.target += shift;
    // Nothing grows by coming nearer in a parallel view: its height takes the distance's place.
    if (frustum.parallel()) result.height *= std::exp(-step.z / glm::length(result.target - result.eye));
    return result;
}

Camera centredOn(const View& view, const Vec3& point) {
    Camera result = view.camera();
    const Vec3& forward = view.frustum().forward;
    const double depth = glm::dot(point - result.eye, forward);
    if (!(depth > 0.0)) return result;
    result.eye = point - depth * forward;
    result.target = point;
    return result;
}

Camera framed(const Camera& camera, UpAxis up, const Sphere& sphere, double aspect) {
    Camera result = turned(camera, up, {}, {});
    const double halfHeight = camera.fovy.radians() / 2.0;
    const double halfWidth = std::atan(std::tan(halfHeight) * aspect);
    const double radius = sphere.radius > 0.0 ? sphere.radius : 1.0;
    if (camera.projection == ProjectionKind::Parallel) {
        result.height = 2.0 * kFramingMargin * radius * std::max(1.0, 1.0 / aspect);
        result.eye += sphere.centre - result.target;
        result.target = sphere.centre;
        return result;
    }
    const double distance = kFramingMargin * radius / std::sin(std::min(halfHeight, halfWidth));
    const Vec3 direction = glm::normalize(result.eye - result.target);
    result.target = sphere.centre;
    result.eye = sphere.centre + distance * direction;
    return result;
}

Camera homeCamera(const Scene& scene, UpAxis up, double aspect) {
    Camera camera = overviewCamera(scene, aspect);
    if (up == scene.upAxis()) return camera;
    const Vec3 offset = camera.eye - camera.target;
    camera.eye = camera.target + (up == UpAxis::Z ? Vec3(offset.x, -offset.z, offset.y) : Vec3(offset.x, offset.z, -offset.y));
    camera.up = axisVector(up);
    return camera;
}

namespace {

/// Moves a camera without turning it so that points and a sphere fill the picture. Both sides of the picture touch one of them,
/// or its top and bottom do.
Camera filledBy(const Camera& camera, std::span<const Vec3> points, const Sphere& sphere, double aspect) {
    const View seen(camera, {1, 1});
    const Frustum& frustum = seen.frustum();
    const double tanHeight = std::tan(camera.fovy.radians() / 2.0) / kFramingMargin, tanWidth = aspect * tanHeight;
    // How far a place lies beyond the plane through the eye at one of the picture's sides, along `axis`.
    const auto beyond = [&](const Vec3& axis, double tangent) {
        const auto of = [&](const Vec3& place) {
            const Vec3 offset = place - camera.eye;
            return glm::dot(offset, axis) - tangent * glm::dot(offset, frustum.forward);
        };
        double most = of(sphere.centre) + sphere.radius * std::sqrt(1.0 + tangent * tangent);
        for (const Vec3& point : points) most = std::max(most, of(point));
        return most;
    };
    const double right = beyond(frustum.right, tanWidth), left = beyond(-frustum.right, tanWidth);
    const double top = beyond(frustum.up, tanHeight), bottom = beyond(-frustum.up, tanHeight);
    const double back = std::max((right + left) / (2.0 * tanWidth), (top + bottom) / (2.0 * tanHeight));
    Camera result = camera;
    result.eye += (right - left) / 2.0 * frustum.right + (top - bottom) / 2.0 * frustum.up - back * frustum.forward;
    result.target = result.eye + glm::dot(sphere.centre - result.eye, frustum.forward) * frustum.forward;
    return result;
}

}  // namespace

Camera observerCamera(const View& culling, const Sphere& scene, UpAxis up, double aspect) {
    const Camera& camera = culling.camera();
    const Camera lens{camera.eye, camera.target, axisVector(up)};
    // A parallel view has no eye that could be seen.
    std::vector<Vec3> corners;
    if (camera.projection == ProjectionKind::Perspective) corners.push_back(camera.eye);
    // What lies beyond the scene, as of a lens with a far plane of its own, is left out; and as the corners of a very wide
    // frustum lie far beside everything, only its beginning is framed then.
    Frustum frustum = culling.frustum();
    const double widest = std::max(frustum.tanHalfWidth, frustum.tanHalfHeight);
    const double reach = kBeyondScene * (glm::length(camera.eye - scene.centre) + scene.radius);
    double shown = 1.0;
    if (frustum.parallel())
        frustum.farDistance = std::max(std::min(frustum.farDistance, reach), frustum.nearDistance);
    else
        shown = std::min({1.0, kWidestFramed / widest, reach / frustum.farDistance});
    for (const Vec3& corner : frustum.corners()) corners.push_back(camera.eye + shown * corner);
    const Camera beside = turned(lens, up, kObserverAzimuth, kObserverElevation);
    return filledBy(beside, corners, Sphere{scene.centre, scene.radius > 0.0 ? scene.radius : 1.0}, aspect);
}

Camera withClipPlanes(const Camera& camera, const Sphere& scene, const std::optional<double>& chosenNear) {
    Camera result = camera;
    const double radius = scene.radius > 0.0 ? scene.radius : 1.0;
    if (camera.projection == ProjectionKind::Parallel) {
        // Where the eye stands on its line changes nothing but what lies behind it: it stands before the whole scene.
        const Vec3 forward = glm::normalize(camera.target - camera.eye);
        const double fromTarget = glm::dot(scene.centre - camera.target, forward);
        const double back = std::max(2.0 * radius - fromTarget, 0.1 * radius);
        result.eye = camera.target - back * forward;
        const double ahead = back + fromTarget;
        result.farDistance = kBeyondScene * (ahead + radius);
        result.nearDistance = std::clamp(chosenNear.value_or(0.99 * (ahead - radius)), 1e-3 * radius, 0.9 * result.farDistance);
        return result;
    }
    const double toCentre = glm::length(camera.eye - scene.centre);
    const double reach = glm::length(camera.eye - camera.target);
    result.farDistance = kBeyondScene * (toCentre + radius);
    const double aroundScene = std::max(0.99 * (toCentre - radius), 1e-4 * radius);
    const double wanted = chosenNear.value_or(std::min(aroundScene, 0.05 * reach));
    result.nearDistance = std::clamp(wanted, kNearestNearPlane * result.farDistance, 0.9 * result.farDistance);
    return result;
}

Vec3 pointUnder(const View& view, const Vec2& pixel, double depth) {
    const Camera& camera = view.camera();
    double distance = glm::dot(camera.target - camera.eye, view.frustum().forward);
    if (depth > 0.0) distance = view.distanceFromDepth(depth);
    return view.pointAt(pixel.x, pixel.y, distance);
}

}  // namespace cullscope
