#pragma once

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope::ordering {

/// So many pixels an order by exact positions may be away from the picture that OpenGL's floats draw: as near to an edge or to
/// the line in which two surfaces meet nothing counts as lost (measure/accuracy.h, pixelsMissedBeyondSnapping).
inline constexpr double kMostDisplacedPixels = 1.0 / 64;

/// Whether the rounding of OpenGL's floats displaces each surface that a perspective view shows by at most kMostDisplacedPixels;
/// true of a parallel view, which has no order.
/// A corner is displaced by up to 2^-21 of its distance from the eye (geometry/frustum.h, conservativeMargin), wherever the
/// triangle is nearest: an eye just before a large surface, or a tiny field of view, sees it shifted by many pixels. The order of
/// exact positions is then not that of what is drawn. Costs a pass over the triangles of objects near the eye.
[[nodiscard]] bool surfacesStandStill(const Scene& scene, const View& view);

}  // namespace cullscope::ordering
