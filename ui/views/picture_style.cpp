// The colours of pictures by the window's palette.
#include "ui/views/scene_view.h"

namespace cullscope::ui {

namespace {

constexpr QRgb kDarkBackground = 0x14171c;
constexpr QRgb kDarkSurface = 0xccccc7;
constexpr QRgb kLightBackground = 0xffffff;
constexpr QRgb kLightSurface = 0xb8b8b3;

Vec3f colour(QRgb rgb) { return Vec3f(float(qRed(rgb)), float(qGreen(rgb)), float(qBlue(rgb))) / 255.0f; }

}  // namespace

DrawStyle pictureStyle(const QPalette& palette) {
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    DrawStyle style;
    style.background = colour(dark ? kDarkBackground : kLightBackground);
    style.surface = colour(dark ? kDarkSurface : kLightSurface);
    return style;
}

}  // namespace cullscope::ui
