#pragma once

#include "ui/panels/cell_picture.h"
#include "ui/panels/map_layout.h"
#include "ui/panels/map_symbols.h"

namespace cullscope::ui {

/// Paints the θ–φ map of an object, in the window and in files: cells by colour, what was decided on them, axes, and what all of
/// it means. Keeps the cells' picture until contents, colouring or size change.
class MapPainter {
public:
    void setContents(const MapContents& contents) { m_cells.setContents(contents); }
    [[nodiscard]] const MapContents& contents() const { return m_cells.contents(); }
    void setColouring(MapColouring colouring) { m_cells.setColouring(colouring); }
    [[nodiscard]] MapColouring colouring() const { return m_cells.colouring(); }

    /// The height that all of it needs in a width; it does not depend on the decision, so that nothing jumps while the camera
    /// moves.
    [[nodiscard]] double neededHeight(double width, const QFontMetricsF& metrics) const;
    /// Where the map stands in a place.
    [[nodiscard]] MapLayout layout(const QRectF& place, const QFontMetricsF& metrics) const;
    /// Needs contents that are not empty. The cursor is for the window alone.
    void paint(QPainter& painter, const QRectF& place, const QPalette& palette,
               const std::optional<SphericalGrid::Cell>& cursor = {}) const;

    /// What the veil makes of a cell in the middle of the scale, of which the legend shows it.
    [[nodiscard]] QColor veiledColour(const QPalette& palette) const;

    /// The cells that a triangle of the shown mesh touches.
    [[nodiscard]] static std::vector<SphericalGrid::Cell> cellsOf(const SphericalMaps& maps, uint32_t triangle);
    [[nodiscard]] static SphericalGrid::Cell centroidCell(const SphericalMaps& maps, uint32_t triangle);

private:
    void paintCaption(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    static void paintAxes(QPainter& painter, const QRectF& area, const MapColours& colours);
    /// What stands between the scale and the legend of a map with a quadtree.
    [[nodiscard]] double wordsHeight(const QFontMetricsF& metrics) const;
    void paintWords(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    void paintScale(QPainter& painter, const QRectF& place, const QPalette& palette) const;
    /// What stands below map and scale.
    [[nodiscard]] MapLegend legend(const QFontMetricsF& metrics, const QPalette& palette) const;
    [[nodiscard]] double heightBelow(double width, const QFontMetricsF& metrics) const;
    [[nodiscard]] std::vector<MapLegend::Entry> statesShown(const QPalette& palette) const;

    CellPicture m_cells;
};

}  // namespace cullscope::ui
