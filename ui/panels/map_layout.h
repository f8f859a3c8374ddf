#pragma once

#include <QFontMetricsF>
#include <QRectF>
#include <optional>

#include "core/visibility/spherical/decision.h"

namespace cullscope::ui {

/// Where directions stand on a picture of the θ–φ map: φ from 0 to 360° to the right, θ from 0 to 180° downwards.
struct MapLayout {
    /// The largest map, twice as wide as high, in a place that also takes the axes' numbers.
    MapLayout(const QRectF& place, const QFontMetricsF& metrics);
    /// The height that map and axes take in a width.
    [[nodiscard]] static double heightFor(double width, const QFontMetricsF& metrics);

    /// Of θ and φ in radians, any φ.
    [[nodiscard]] QPointF placeOf(const Vec2& thetaPhi) const;
    /// None: outside of the map.
    [[nodiscard]] std::optional<SphericalGrid::Cell> cellAt(const SphericalGrid& grid, const QPointF& position) const;
    [[nodiscard]] QRectF rectOf(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;
    [[nodiscard]] QRectF rectOf(const SphericalGrid& grid, const spherical::CellBox& box) const;

    QRectF area;  ///< of the map alone, on whole pixels
};

}  // namespace cullscope::ui
