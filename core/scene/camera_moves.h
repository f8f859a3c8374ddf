#pragma once

#include <optional>

#include "core/geometry/bounds.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Which world axis points up on the screen.
enum class UpAxis { Y, Z };
[[nodiscard]] Vec3 axisVector(UpAxis up);

/// Camera moves as plain functions. All keep the camera finite and its eye off its target; none touches near and far
/// (see withClipPlanes).

/// Turns about the target like a turntable: `azimuth` about the up axis, `elevation` towards it, stopping short of the poles.
[[nodiscard]] Camera turned(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation);
/// Looks at the same target from a direction (target to eye, any length); along the up axis as near to the pole as turned() goes.
[[nodiscard]] Camera seenFrom(const Camera& camera, UpAxis up, const Vec3& direction);
/// Turns the direction of sight about the eye, stopping short of the poles.
[[nodiscard]] Camera looked(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation);
/// Slides sideways so that the world point under pixel `from` at forward distance `distance` comes under pixel `to`.
[[nodiscard]] Camera panned(const View& view, double distance, const Vec2& from, const Vec2& to);
/// Scales the distance from `point` by `factor` (below 1: nearer); `point` keeps its place in the picture.
/// So near to the point that nothing could be told apart any more, it goes on through it instead of stopping.
[[nodiscard]] Camera zoomed(const Camera& camera, const Vec3& point, double factor, double sceneRadius);
/// Moves eye and target by `step`: right, up, forward in units of the scene.
[[nodiscard]] Camera flown(const View& view, const Vec3& step);
/// Makes `point` the target and slides sideways so that it stands in the middle; direction and depth stay.
[[nodiscard]] Camera centredOn(const View& view, const Vec3& point);
/// Keeps the direction and shows all of `sphere`.
[[nodiscard]] Camera framed(const Camera& camera, UpAxis up, const Sphere& sphere, double aspect);
/// The first view of a scene.
[[nodiscard]] Camera homeCamera(const Scene& scene, UpAxis up, double aspect);

/// A look from the side and above at a culling camera together with the scene it sees.
[[nodiscard]] Camera observerCamera(const Camera& culling, const Sphere& scene, UpAxis up, double aspect);

/// Near and far around the scene as seen from the camera; `chosenNear` takes the place of the near distance.
[[nodiscard]] Camera withClipPlanes(const Camera& camera, const Sphere& scene, const std::optional<double>& chosenNear);

/// The world point under a pixel (y upward) with the depth sample found there; where nothing is drawn (0),
/// the point in the target's plane.
[[nodiscard]] Vec3 pointUnder(const View& view, const Vec2& pixel, double depth);

}  // namespace cullscope
