#pragma once

#include <optional>

#include "core/geometry/bounds.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

[[nodiscard]] Vec3 axisVector(UpAxis up);

/// Camera moves as free functions. All keep the camera finite and its eye away from its target; none changes near and far (see
/// withClipPlanes).

/// Orbits the target like a turntable: by `azimuth` about the up axis, by `elevation` towards it, stopping before the poles.
[[nodiscard]] Camera turned(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation);
/// The same about another point, which keeps its place in the picture.
[[nodiscard]] Camera turnedAbout(const Camera& camera, UpAxis up, const Vec3& pivot, Angle azimuth, Angle elevation);
/// Looks at the same target from a direction (target to eye, any length); along the up axis, as near to the pole as turned()
/// goes.
[[nodiscard]] Camera seenFrom(const Camera& camera, UpAxis up, const Vec3& direction);
/// Rotates the view direction about the eye, stopping before the poles; of a parallel camera about the target.
[[nodiscard]] Camera looked(const Camera& camera, UpAxis up, Angle azimuth, Angle elevation);
/// Translates sideways so that the world point under pixel `from` at forward distance `distance` moves to pixel `to`.
[[nodiscard]] Camera panned(const View& view, double distance, const Vec2& from, const Vec2& to);
/// Scales the distance from `point` by `factor` (below 1: nearer); `point` keeps its place in the picture. At a distance so small
/// that double would no longer resolve it, the eye moves on through the point instead of stopping. Of a parallel camera the
/// view's height changes, and the eye moves sideways.
[[nodiscard]] Camera zoomed(const Camera& camera, const Vec3& point, double factor, double sceneRadius);
/// Moves eye and target by `step`: right, up, forward, in scene units. Forward, a parallel view's height shrinks besides.
[[nodiscard]] Camera flown(const View& view, const Vec3& step);
/// Makes `point` the target and translates sideways so that it is in the middle of the picture; view direction and depth stay.
[[nodiscard]] Camera centredOn(const View& view, const Vec3& point);
/// Keeps the view direction and moves so that all of `sphere` is in view.
[[nodiscard]] Camera framed(const Camera& camera, UpAxis up, const Sphere& sphere, double aspect);
/// The initial camera of a scene.
[[nodiscard]] Camera homeCamera(const Scene& scene, UpAxis up, double aspect);

/// A camera that looks from the side and above at a culling view and the scene: all of its frustum as far as the scene reaches,
/// its eye and the scene's sphere are in the picture, and fill it in one direction.
[[nodiscard]] Camera observerCamera(const View& culling, const Sphere& scene, UpAxis up, double aspect);

/// Sets near and far so that they enclose the scene as seen from the camera; `chosenNear` replaces the near distance.
/// The eye of a parallel camera moves along its line of sight to before the scene, so that none of it lies behind.
[[nodiscard]] Camera withClipPlanes(const Camera& camera, const Sphere& scene, const std::optional<double>& chosenNear);

/// The world point under a pixel (y upward) with the depth sample at that pixel; where nothing is drawn (depth 0), the point in
/// the plane through the target.
[[nodiscard]] Vec3 pointUnder(const View& view, const Vec2& pixel, double depth);

}  // namespace cullscope
