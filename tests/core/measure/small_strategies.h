#pragma once

#include "core/visibility/registry.h"

namespace cullscope::test {

// The smallest strategies of kinds that the registered ones do not have: what they need of FrameContext, and no more.

/// Draws every triangle as one of its own, far objects first, without depth test. Exact on objects that are convex, disjoint and
/// of equal size, whose front sides alone are drawn.
[[nodiscard]] RegisteredStrategy backToFront();

/// Shows a picture made on the processor, by a ray through the centre of every pixel.
[[nodiscard]] RegisteredStrategy tracedPicture();

/// Draws the nearer half of the objects, has the boxes of the others tested against the depth drawn so far, and goes on with
/// those that are visible.
[[nodiscard]] RegisteredStrategy halfThenAsk();

/// Draws the objects whose boxes were visible in the view's last frame (in the first: all), and asks about all boxes afterwards.
[[nodiscard]] RegisteredStrategy lastFrame();

/// Has a compute shader test the objects' spheres against the planes of the view and draw those that it keeps.
[[nodiscard]] RegisteredStrategy chosenByGpu();

}  // namespace cullscope::test
