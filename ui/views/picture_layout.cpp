#include "ui/views/picture_layout.h"

#include <algorithm>
#include <cmath>

namespace cullscope::ui {

namespace {

/// A whole number is preferred down to this share of the length that would fit.
constexpr double kLeastShareOfWhole = 0.85;

/// Device pixels per picture pixel where `fitting` of them have room.
double scaleFor(double fitting) {
    const double whole = std::floor(fitting);
    return whole >= kLeastShareOfWhole * fitting ? whole : fitting;
}

}  // namespace

PictureLayout::PictureLayout(const QSizeF& place, double pixelRatio, const Viewport& picture) : m_picture(picture) {
    const QSizeF device(std::round(place.width() * pixelRatio), std::round(place.height() * pixelRatio));
    const double fitting = std::min(device.width() / picture.width, device.height() / picture.height);
    m_scale = std::max(scaleFor(fitting), 1.0 / std::max(picture.width, picture.height));
    const QSizeF size(std::max(1.0, std::round(m_scale * picture.width)), std::max(1.0, std::round(m_scale * picture.height)));
    const QPointF corner(std::floor((device.width() - size.width()) / 2.0), std::floor((device.height() - size.height()) / 2.0));
    m_rect = QRectF(corner / pixelRatio, size / pixelRatio);
}

Vec2 PictureLayout::pixelAt(const QPointF& position) const {
    const QPointF share((position.x() - m_rect.x()) / m_rect.width(), (position.y() - m_rect.y()) / m_rect.height());
    return {share.x() * m_picture.width, (1.0 - share.y()) * m_picture.height};
}

QPointF PictureLayout::positionOf(const Vec2& pixel) const {
    return {m_rect.x() + pixel.x / m_picture.width * m_rect.width(),
            m_rect.y() + (1.0 - pixel.y / m_picture.height) * m_rect.height()};
}

}  // namespace cullscope::ui
