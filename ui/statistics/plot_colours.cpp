#include "ui/statistics/plot_colours.h"

#include <array>

namespace cullscope::ui {

namespace {

// After Okabe and Ito, darkened or lightened for a contrast of at least 3 : 1 against the ground.
constexpr std::array<QRgb, 8> kOnLight{0x0072B2, 0xC44E00, 0x00805A, 0xA8447E, 0x7A5C00, 0x2E86C8, 0x5B3FA8, 0x8A2B2B};
constexpr std::array<QRgb, 8> kOnDark{0x56B4E9, 0xFF9A4D, 0x2BD4A4, 0xF0A6D0, 0xF0E442, 0x8FC7FF, 0xB79CFF, 0xFF8A8A};

QColor between(const QColor& a, const QColor& b, double share) {
    const auto mix = [share](int from, int to) { return int(from + (to - from) * share); };
    return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

}  // namespace

PlotColours::PlotColours(const QPalette& palette)
    : ground(palette.color(QPalette::Base)), text(palette.color(QPalette::Text)), dark(ground.lightness() < 128) {
    faintText = palette.color(QPalette::PlaceholderText);
    grid = between(ground, text, dark ? 0.25 : 0.16);
    cull = dark ? QColor(0xFF9A4D) : QColor(0xC44E00);
    draw = dark ? QColor(0x3F8FC4) : QColor(0x4A9BD1);
    baselineCull = between(ground, text, 0.75);
    baselineDraw = between(ground, text, dark ? 0.45 : 0.4);
    noLoss = dark ? QColor(0x9AA1AB) : QColor(0x62676E);
    loss = dark ? QColor(0xFF5470) : QColor(0xD0105A);
    chosen = palette.color(QPalette::Highlight);
}

QColor PlotColours::series(size_t number) const {
    return QColor(dark ? kOnDark[number % kOnDark.size()] : kOnLight[number % kOnLight.size()]);
}

}  // namespace cullscope::ui
