#pragma once

#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope {

/// So many pixels the picture of exact positions may be away from the one that OpenGL's floats draw: as near to an edge or to
/// the line in which two surfaces meet nothing counts as lost (measure/accuracy.h, pixelsMissedBeyondSnapping).
inline constexpr double kMostDisplacedPixels = 1.0 / 64;

/// Whether the rounding of OpenGL's floats displaces each surface that a view shows by at most kMostDisplacedPixels. A corner is
/// displaced by up to 2^-21 of its distance from the eye (geometry/frustum.h, conservativeMargin), wherever the triangle is
/// nearest, and moves the more in the picture the farther aside it lies: at 179 degrees a hundred times what it moves in the
/// middle; in a parallel view, whose pixels are as wide at each distance, of its distance from the line through the eye along the
/// view. An eye just before a large surface, or a tiny field of view or height, sees it shifted by many pixels. What is computed
/// of positions on the processor, an order or a picture, is then not that of what OpenGL draws, and two OpenGLs that round in
/// another order differ. Costs a pass over the triangles of objects near the eye.
[[nodiscard]] bool surfacesStandStill(const Scene& scene, const View& view);

/// The promise at a view of a strategy whose picture follows from positions that it computes itself: `promise`, or nothing where
/// surfaces do not stand still.
[[nodiscard]] Promise promiseWhereSurfacesStandStill(Promise promise, const Scene& scene, const View& view);

}  // namespace cullscope
