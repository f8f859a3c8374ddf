#pragma once

#include <optional>

#include "core/frame/draw_list.h"
#include "core/raster/projection.h"

// Triangles one by one; for the source files of this folder.

namespace cullscope {

using RasterCorners = std::array<RasterVertex, 3>;

/// Twice the area in units of 1/256 pixel, above 0 where the corners are in counter-clockwise order.
[[nodiscard]] inline int64_t twiceArea(const RasterVertex& a, const RasterVertex& b, const RasterVertex& c) {
    return int64_t(b.x - a.x) * (c.y - a.y) - int64_t(c.x - a.x) * (b.y - a.y);
}

/// The triangle of three corners on the raster; none where its box has no pixel centre. `area` is its twiceArea, and not 0.
[[nodiscard]] std::optional<ScreenTriangle> screenTriangle(const RasterCorners& corners, int64_t area, uint32_t number,
                                                           const Viewport& size);

/// What became of a triangle on its way to the raster.
enum class RasterFate { OnRaster, FacingAway, WithoutSample };

/// Which sides of an instance's triangles are drawn.
struct RasterFacing {
    RasterFacing() = default;  ///< both
    RasterFacing(const Scene& scene, size_t instance, Facing facing);

    [[nodiscard]] bool drops(int64_t area) const { return front && (area < 0) != mirrored; }

    bool front = false, mirrored = false;
};

/// Appends the parts of a triangle that are left where it is clipped at the near plane and at the raster's range. Its corners are
/// given in clip space.
RasterFate addClipped(const Projection& projection, const std::array<Clip, 3>& corners, const RasterFacing& facing,
                      uint32_t number, const Viewport& size, std::vector<ScreenTriangle>& triangles);

}  // namespace cullscope
