#pragma once

#include <QFontMetricsF>
#include <QPainterPath>
#include <array>

#include "ui/panels/map_layout.h"
#include "ui/panels/map_symbols.h"

namespace cullscope::ui {

/// Paints over a map's cells what was decided on them. Whatever crosses the seam is painted on both sides of it.
class MapOverlay {
public:
    MapOverlay(QPainter& painter, const MapLayout& layout, const MapColours& colours)
        : m_painter(painter), m_layout(layout), m_colours(colours) {}

    /// The corner rays' walked cells, the visible region, its boxes and the four corners; or the contour bands and the edge of
    /// what they leave; or the cells of the quadtree at which the walk ended, as far as they are seen, and the kernel's horizon.
    void paint(const spherical::MapSnapshot& map) const;
    void paintPicked(const SphericalGrid& grid, const std::vector<SphericalGrid::Cell>& cells,
                     const SphericalGrid::Cell& centroid) const;
    /// The edges of a sector of the bands: there β stays the same from the start to the end.
    void paintSector(const spherical::ContourBands& bands, uint32_t sector) const;
    void paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;

private:
    void paintWalked(const spherical::MapSnapshot& map) const;
    void paintRegion(const SphericalGrid& grid, const spherical::VisibleRegion& region) const;
    void paintCorners(const spherical::SphericalDecision& decision) const;
    void paintBands(const spherical::ContourBands& bands) const;
    void paintWalk(const spherical::MapSnapshot& map) const;
    /// A line of (θ, φ) with φ continued over the seam, once for every turn that it reaches into; at least one point.
    [[nodiscard]] QPainterPath wrapped(const std::vector<Vec2>& line, bool closed) const;

    QPainter& m_painter;
    const MapLayout& m_layout;
    const MapColours& m_colours;
};

/// (θ, φ) of a corner of the region.
[[nodiscard]] Vec2 cornerOf(const spherical::CornerRay& ray);
/// Where the four corners' numbers stand: within the map, and on no corner's marker.
[[nodiscard]] std::array<QRectF, 4> cornerNumbers(const MapLayout& layout, const spherical::SphericalDecision& decision,
                                                  const QFontMetricsF& metrics);
/// From one drawn contour to the next, radians: a whole number of bands.
[[nodiscard]] double contourStep(const spherical::ContourBands& bands);
/// The directions at one angle β about the axis, from α = 0 to 180°, as lines of (θ, φ), φ continued over the seam; two, where
/// they go over a pole of the map.
[[nodiscard]] std::vector<std::vector<Vec2>> sectorEdge(const spherical::ContourBands& bands, double beta);

}  // namespace cullscope::ui
