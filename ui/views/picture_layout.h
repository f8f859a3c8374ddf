#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/geometry/types.h"
#include "core/scene/camera.h"

namespace cullscope::ui {

/// Where a picture of a given size lies in its place in the window, letterboxed: as it is or enlarged by a whole number where it
/// fits, else made smaller.
class PictureLayout {
public:
    /// `place` in the window's coordinates; `pixelRatio` device pixels are one of those.
    PictureLayout(const QSizeF& place, double pixelRatio, const Viewport& picture);

    /// In the window's coordinates, on whole device pixels.
    [[nodiscard]] const QRectF& rect() const { return m_rect; }
    /// Device pixels a picture pixel.
    [[nodiscard]] double scale() const { return m_scale; }
    /// Pixels of the picture (y upward) from a position in the window.
    [[nodiscard]] Vec2 pixelAt(const QPointF& position) const;
    /// The position of a pixel (y upward).
    [[nodiscard]] QPointF positionOf(const Vec2& pixel) const;

private:
    Viewport m_picture;
    double m_scale = 1.0;
    QRectF m_rect;
};

}  // namespace cullscope::ui
