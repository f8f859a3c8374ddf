#pragma once

#include "ui/families/spherical/cell_picture.h"
#include "ui/families/spherical/map_layout.h"
#include "ui/families/spherical/map_symbols.h"

namespace cullscope::ui {

/// Paints the θ–φ map of an object for windows and files: coloured cells, the decision on them, axes, and a legend. Caches the
/// image of the cells until contents, colouring or size change.
class MapPainter {
public:
    void setContents(const MapContents& contents) { m_cells.setContents(contents); }
    [[nodiscard]] const MapContents& contents() const { return m_cells.contents(); }
    void setColouring(spherical::MapColouring colouring) { m_cells.setColouring(colouring); }
    [[nodiscard]] spherical::MapColouring colouring() const { return m_cells.colouring(); }

    /// The height of the whole picture for a given width. It does not depend on the decision, so that the layout is stable while
    /// the camera moves.
    [[nodiscard]] double neededHeight(double width, const QFontMetricsF& metrics) const;
    /// The layout of the map in a rectangle.
    [[nodiscard]] MapLayout layout(const QRectF& place, const QFontMetricsF& metrics) const;
    /// Paints the map. The contents must not be empty. The cursor is painted in windows only.
    void paint(QPainter& painter, const QRectF& place, const QPalette& palette,
               const std::optional<SphericalGrid::Cell>& cursor = {}) const;

    /// The colour of a cell from the middle of the scale under the veil, as the legend shows it.
    [[nodiscard]] QColor veiledColour(const QPalette& palette) const;

    /// The cells that a triangle of the shown mesh touches.
    [[nodiscard]] static std::vector<SphericalGrid::Cell> cellsOf(const SphericalMaps& maps, uint32_t triangle);
    [[nodiscard]] static SphericalGrid::Cell centroidCell(const SphericalMaps& maps, uint32_t triangle);

private:
    void paintCaption(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    static void paintAxes(QPainter& painter, const QRectF& area, const MapColours& colours);
    /// The height of the lines between scale and legend, which maps with a quadtree have.
    [[nodiscard]] double wordsHeight(const QFontMetricsF& metrics) const;
    void paintWords(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    void paintScale(QPainter& painter, const QRectF& place, const QPalette& palette) const;
    /// The legend below map and scale.
    [[nodiscard]] MapLegend legend(const QFontMetricsF& metrics, const QPalette& palette) const;
    [[nodiscard]] double heightBelow(double width, const QFontMetricsF& metrics) const;
    [[nodiscard]] std::vector<MapLegend::Entry> statesShown(const QPalette& palette) const;

    CellPicture m_cells;
};

}  // namespace cullscope::ui
