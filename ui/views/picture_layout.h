#pragma once

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include "core/geometry/types.h"
#include "core/scene/camera.h"

namespace cullscope::ui {

/// The rectangle of a picture in its place in the window, letterboxed. It fits its place, or is enlarged by a whole number of
/// device pixels where that leaves little of the place empty: then each of its pixels is a square of the screen's.
class PictureLayout {
public:
    /// `place` in window coordinates, each of which is `pixelRatio` device pixels.
    PictureLayout(const QSizeF& place, double pixelRatio, const Viewport& picture);

    /// The rectangle in window coordinates, aligned to device pixels.
    [[nodiscard]] const QRectF& rect() const { return m_rect; }
    /// Device pixels per picture pixel.
    [[nodiscard]] double scale() const { return m_scale; }
    /// The picture pixel (y upward) at a position in the window.
    [[nodiscard]] Vec2 pixelAt(const QPointF& position) const;
    /// The position of a picture pixel (y upward) in the window.
    [[nodiscard]] QPointF positionOf(const Vec2& pixel) const;

private:
    Viewport m_picture;
    double m_scale = 1.0;
    QRectF m_rect;
};

}  // namespace cullscope::ui
