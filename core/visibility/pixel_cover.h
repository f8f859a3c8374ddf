#pragma once

#include <cstdint>

#include "core/scene/camera.h"

namespace cullscope {

/// Bounds from above how many pixel centres of a view's picture the projection of a box covers, as OpenGL draws what lies in it.
class PixelCover {
public:
    explicit PixelCover(const View& view);

    /// The number of pixel centres of the picture in the rectangle around the projected box, which grows by the rounding of a
    /// picture: vertices are snapped to 1/256 of a pixel and transformed in float. All pixels for a box that reaches to the eye's
    /// plane or behind it. `box` is relative to the eye. NaN in the box: all pixels.
    [[nodiscard]] uint64_t of(const EyeBox& box) const;
    /// A length at a distance ahead of the eye is at least this many pixels for each scene unit: for tests that need no corners.
    [[nodiscard]] double pixelsPerUnit(double ahead) const { return m_frustum.parallel() ? m_pixels : m_pixels / ahead; }
    /// By how much the projection of what lies in a box grows on each side for the rounding of a picture, in pixels.
    [[nodiscard]] double roomFor(const EyeBox& box) const;

private:
    Frustum m_frustum;
    Viewport m_size;
    double m_pixels;  ///< the width of a unit at distance 1, in pixels
    double m_room;    ///< in perspective: by how much a projection grows on each side, in pixels
};

}  // namespace cullscope
