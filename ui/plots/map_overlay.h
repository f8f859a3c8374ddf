#pragma once

#include <QFontMetricsF>
#include <QPainterPath>
#include <vector>

#include "ui/plots/map_layout.h"
#include "ui/plots/map_symbols.h"

namespace cullscope::ui {

/// Paints what lies over a map's cells. Shapes that cross the seam at φ = 0 are painted on both sides of it.
class MapOverlay {
public:
    MapOverlay(QPainter& painter, const MapLayout& layout, const MapColours& colours)
        : m_painter(painter), m_layout(layout), m_colours(colours) {}

    /// Paints the circles about an axis; the strategy's own cells, as far as they can be seen; walked cells, boxes and curves.
    void paint(const CellMap& map) const;
    /// Paints the labels of circles, and the marks with their numbers. After all lines, which would cross them.
    void paintLabels(const CellMap& map) const;
    void paintPicked(const SphericalGrid& grid, const std::vector<SphericalGrid::Cell>& cells,
                     const SphericalGrid::Cell& centroid) const;
    /// Paints the edges of a part.
    void paintPart(const CellMap& map, uint32_t part) const;
    /// Paints lines around the subject in hand of a stepped view.
    void paintInHand(const std::vector<std::vector<Vec2>>& lines) const;
    void paintCursor(const SphericalGrid& grid, const SphericalGrid::Cell& cell) const;

private:
    void paintWalked(const CellMap& map) const;
    void paintBoxes(const CellMap& map) const;
    void paintCurves(const CellMap& map) const;
    void paintMarks(const std::vector<MapMark>& marks) const;
    void paintCircles(const MapCircles& circles) const;
    void paintOutlines(const CellMap& map) const;
    /// The path of a line of (θ, φ) whose φ continues over the seam, once for every turn that it reaches. Needs at least one
    /// point.
    [[nodiscard]] QPainterPath wrapped(const std::vector<Vec2>& line, bool closed) const;

    QPainter& m_painter;
    const MapLayout& m_layout;
    const MapColours& m_colours;
};

/// Rectangles of the marks' numbers: within the map, and clear of the markers.
[[nodiscard]] std::vector<QRectF> markNumbers(const MapLayout& layout, const std::vector<MapMark>& marks,
                                              const QFontMetricsF& metrics);

/// The label of a circle about the axis.
struct CircleLabel {
    int degrees = 0;  ///< angle from the axis
    QRectF place;     ///< within the map
};
/// Labels of every 30°, as many as fit beside each other: a low map has that of the right angle alone.
[[nodiscard]] std::vector<CircleLabel> circleLabels(const MapLayout& layout, const MapCircles& circles,
                                                    const QFontMetricsF& metrics);

}  // namespace cullscope::ui
