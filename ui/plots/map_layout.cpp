#include "ui/plots/map_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cullscope::ui {

namespace {

constexpr double kAxisGap = 4.0;

double leftOf(const QFontMetricsF& metrics) {
    return std::ceil(metrics.horizontalAdvance(QStringLiteral("180°")) + 2 * kAxisGap);
}
/// Half of the last number reaches beyond the right edge of the map.
double rightOf(const QFontMetricsF& metrics) { return std::ceil(metrics.horizontalAdvance(QStringLiteral("360°")) / 2); }
/// Half of the first number reaches beyond the upper edge of the map.
double topOf(const QFontMetricsF& metrics) { return std::ceil(metrics.height() / 2); }
double bottomOf(const QFontMetricsF& metrics) { return std::ceil(metrics.height() + kAxisGap); }

}  // namespace

MapLayout::MapLayout(const QRectF& place, const QFontMetricsF& metrics) {
    const double left = leftOf(metrics), top = topOf(metrics);
    const double across = place.width() - left - rightOf(metrics), down = place.height() - top - bottomOf(metrics);
    const double height = std::max(2.0, std::floor(std::min(across / 2, down)));
    area = QRectF(std::floor(place.left() + left), std::floor(place.top() + top), 2 * height, height);
}

double MapLayout::heightFor(double width, const QFontMetricsF& metrics) {
    return std::floor((width - leftOf(metrics) - rightOf(metrics)) / 2) + topOf(metrics) + bottomOf(metrics);
}

QPointF MapLayout::placeOf(const Vec2& thetaPhi) const {
    return {area.left() + thetaPhi.y / (2 * std::numbers::pi) * area.width(),
            area.top() + thetaPhi.x / std::numbers::pi * area.height()};
}

std::vector<MapLayout::AxisLabel> MapLayout::axisLabels(const QFontMetricsF& metrics) const {
    constexpr double kGap = 5.0;
    std::vector<AxisLabel> labels;
    const auto below = [&](double x, const QString& words) {
        const double wide = metrics.horizontalAdvance(words);
        labels.push_back({words, {x - wide / 2, area.bottom() + kTick, wide, metrics.height()}});
    };
    const auto beside = [&](double y, const QString& words) {
        const double wide = metrics.horizontalAdvance(words);
        labels.push_back({words, {area.left() - kGap - wide, y - metrics.height() / 2, wide, metrics.height()}});
    };
    const auto degrees = [](int value) { return QStringLiteral("%1°").arg(value); };
    // In large letters beside a small map there is room for the ends alone, or for the beginning.
    const double widest = metrics.horizontalAdvance(degrees(360));
    int across = 90, down = 90;
    while (across < 720 && area.width() * across / 360.0 < 1.2 * widest) across *= 2;
    while (down < 360 && area.height() * down / 180.0 < 1.1 * metrics.height()) down *= 2;
    for (int phi = 0; phi <= 360; phi += across) below(area.left() + phi / 360.0 * area.width(), degrees(phi));
    for (int theta = 0; theta <= 180; theta += down) beside(area.top() + theta / 180.0 * area.height(), degrees(theta));
    // A name stands in the middle between two numbers, apart from both.
    const QString phi = QStringLiteral("φ"), theta = QStringLiteral("θ");
    if (across == 90 && area.width() / 4 >= widest + metrics.horizontalAdvance(phi) + 2 * kGap)
        below(area.left() + 5 * area.width() / 8, phi);
    if (down == 90 && area.height() / 2 >= 2 * metrics.height()) beside(area.top() + 3 * area.height() / 4, theta);
    return labels;
}

std::optional<SphericalGrid::Cell> MapLayout::cellAt(const SphericalGrid& grid, const QPointF& position) const {
    const double across = (position.x() - area.left()) / area.width(), down = (position.y() - area.top()) / area.height();
    if (across < 0.0 || across >= 1.0 || down < 0.0 || down >= 1.0) return std::nullopt;
    return SphericalGrid::Cell{uint32_t(down * grid.rows()), uint32_t(across * grid.columns())};
}

QRectF MapLayout::rectOf(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const {
    return rectOf(grid, SphericalGrid::Box{cell.row, cell.row, cell.column, cell.column});
}

QRectF MapLayout::rectOf(const SphericalGrid& grid, const SphericalGrid::Box& box) const {
    const double width = area.width() / grid.columns(), height = area.height() / grid.rows();
    return {area.left() + box.firstColumn * width, area.top() + box.firstRow * height,
            (box.lastColumn + 1 - box.firstColumn) * width, (box.lastRow + 1 - box.firstRow) * height};
}

}  // namespace cullscope::ui
