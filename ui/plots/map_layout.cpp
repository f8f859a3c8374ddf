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
