#pragma once

#include <QFontMetricsF>
#include <QPainterPath>
#include <array>

#include "ui/families/spherical/map_layout.h"
#include "ui/families/spherical/map_symbols.h"

namespace cullscope::ui {

/// Paints the decision on the cells over a map. Shapes that cross the seam at φ = 0 are painted on both sides of it.
class MapOverlay {
public:
    MapOverlay(QPainter& painter, const MapLayout& layout, const MapColours& colours)
        : m_painter(painter), m_layout(layout), m_colours(colours) {}

    /// Paints, depending on the decision: the cells that the corner rays walked, the visible region, its boxes and the four
    /// corners; or the contour bands and the boundary of the drawn ones; or the quadtree cells at which the walk ended, as far as
    /// they can be seen, and the kernel's horizon.
    void paint(const spherical::MapSnapshot& map) const;
    void paintPicked(const SphericalGrid& grid, const std::vector<SphericalGrid::Cell>& cells,
                     const SphericalGrid::Cell& centroid) const;
    /// Paints the edges of a sector of the bands: lines of constant β from the start to the end of the axis.
    void paintSector(const spherical::ContourBands& bands, uint32_t sector) const;
    void paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;

private:
    void paintWalked(const spherical::MapSnapshot& map) const;
    void paintRegion(const SphericalGrid& grid, const spherical::VisibleRegion& region) const;
    void paintCorners(const spherical::SphericalDecision& decision) const;
    void paintBands(const spherical::ContourBands& bands) const;
    void paintWalk(const spherical::MapSnapshot& map) const;
    /// The path of a line of (θ, φ) whose φ continues over the seam, once for every turn that it reaches. Needs at least one
    /// point.
    [[nodiscard]] QPainterPath wrapped(const std::vector<Vec2>& line, bool closed) const;

    QPainter& m_painter;
    const MapLayout& m_layout;
    const MapColours& m_colours;
};

/// (θ, φ) of a corner of the visible region, from its corner ray.
[[nodiscard]] Vec2 cornerOf(const spherical::CornerRay& ray);
/// Rectangles of the four corners' numbers: within the map, and clear of the corner markers.
[[nodiscard]] std::array<QRectF, 4> cornerNumbers(const MapLayout& layout, const spherical::SphericalDecision& decision,
                                                  const QFontMetricsF& metrics);
/// The angle between two drawn contours in radians: a whole number of bands.
[[nodiscard]] double contourStep(const spherical::ContourBands& bands);
/// The directions at one angle β about the axis, from α = 0 to 180°, as lines of (θ, φ) whose φ continues over the seam. There
/// are two lines if they pass over a pole of the map.
[[nodiscard]] std::vector<std::vector<Vec2>> sectorEdge(const spherical::ContourBands& bands, double beta);

}  // namespace cullscope::ui
