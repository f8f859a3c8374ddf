#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <QString>
#include <optional>
#include <vector>

#include "core/geometry/spherical_grid.h"

namespace cullscope::ui {

/// Positions of directions in a picture of the θ–φ map: φ increases from 0 to 360° to the right, θ from 0 to 180° downwards.
struct MapLayout {
    /// Lays out the largest map, twice as wide as high, that fits into `place` together with the numbers of its axes.
    MapLayout(const QRectF& place, const QFontMetricsF& metrics);
    /// The height of map and axes for a given width.
    [[nodiscard]] static double heightFor(double width, const QFontMetricsF& metrics);

    /// The position of a direction; θ and φ in radians, φ of any value.
    [[nodiscard]] QPointF placeOf(const Vec2& thetaPhi) const;
    /// The cell at a position; none: the position is outside the map.
    [[nodiscard]] std::optional<SphericalGrid::Cell> cellAt(const SphericalGrid& grid, const QPointF& position) const;
    [[nodiscard]] QRectF rectOf(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;
    [[nodiscard]] QRectF rectOf(const SphericalGrid& grid, const SphericalGrid::Box& box) const;

    static constexpr double kTick = 3.0;  ///< length of an axis' ticks, in the painter's units
    struct AxisLabel {
        QString words;
        QRectF place;
    };
    /// The numbers of both axes and, where there is room between them, the axes' names. None lies over another.
    [[nodiscard]] std::vector<AxisLabel> axisLabels(const QFontMetricsF& metrics) const;

    QRectF area;  ///< rectangle of the map without axes, on whole pixels
};

}  // namespace cullscope::ui
