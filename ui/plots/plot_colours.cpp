#include "ui/plots/plot_colours.h"

#include "core/image/plot_drawing.h"

namespace cullscope::ui {

namespace {

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
    const std::span<const PlotColour> colours = plotSeries(dark);
    return QColor(colours[number % colours.size()]);
}

}  // namespace cullscope::ui
