#pragma once

#include "core/geometry/frustum_planes.h"
#include "core/scene/camera.h"

namespace cullscope::frustum {

/// Where a frustum's planes come from.
enum class PlaneSource {
    Basis,       ///< the camera's basis (View::frustum)
    Rows,        ///< rows of the clip matrix: Gribb & Hartmann 2001
    Corners,     ///< corners of the inverse clip cube: Orangelie 2023 with its errors mended
    AsPublished  ///< the same as printed: publishedPlanes
};

/// A view's frustum with planes of another source, relative to the eye. `kept`: false where the matrix gives no planes, or planes
/// that differ from the basis' by more than 2^-24 of a distance, as with near : far beyond all measure; then they are the basis'.
/// So the margin of a plane test (conservativeMargin), which has as much room twice over, covers them.
struct SourcedFrustum {
    Frustum frustum;
    bool kept = true;
};
[[nodiscard]] SourcedFrustum frustumFrom(const View& view, PlaneSource source);

/// The planes of Orangelie 2023 as printed, in world coordinates, with normals that point outward: what has n · p + d > e lies
/// outside, where e is a radius or the length of an extent vector. Corners are those of a left-handed clip cube with depths 0 …
/// 1, multiplied by the inverse matrix as three numbers, without the division by w, so that near and far corners differ by a
/// multiple of the eye's position alone; left, right, bottom and top are the near plane again; normals are not of unit length.
[[nodiscard]] FrustumPlanes publishedPlanes(const View& view);

}  // namespace cullscope::frustum
