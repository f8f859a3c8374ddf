#pragma once

#include <vector>

#include "core/visibility/overlay.h"
#include "core/visibility/plane_colours.h"

namespace cullscope {

/// A frustum, with its far plane moved to the scene's end, and a mark at its eye.
[[nodiscard]] std::vector<OverlayLines> frustumOverlay(const OverlayContext& context, const View& culling);

/// A frustum as it is displayed: with the far plane moved to the scene's end.
[[nodiscard]] Frustum shownFrustum(const View& culling, const Scene& scene);

/// The planes of a frustum as outlines within its faces, each in its own colour.
[[nodiscard]] OverlayLines planeOverlay(const OverlayContext& context, const View& culling);

/// The boxes of objects and tested groups: those that a plane rejected in the plane's colour, with a wider line; the others in
/// the verdict's colour.
[[nodiscard]] std::vector<OverlayLines> boxOverlayByPlane(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The boxes of the objects, coloured by verdict.
[[nodiscard]] OverlayLines boxOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

}  // namespace cullscope
