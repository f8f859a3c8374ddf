#pragma once

#include "ui/plots/cell_picture.h"
#include "ui/plots/map_layout.h"
#include "ui/plots/map_symbols.h"

namespace cullscope::ui {

/// Paints the map of an object for windows and files: coloured cells, what lies over them, axes, and a legend. Caches the
/// image of the cells until contents, colouring or size change.
class MapPainter {
public:
    void setContents(const MapContents& contents) { m_cells.setContents(contents); }
    [[nodiscard]] const MapContents& contents() const { return m_cells.contents(); }
    bool setColouring(const std::string& colouring) { return m_cells.setColouring(colouring); }
    /// Only what was decided stands over the map, and nothing but its axes below.
    void setBrief() { m_brief = true; }
    [[nodiscard]] bool brief() const { return m_brief; }
    /// The id of the shown colouring; empty: there is none.
    [[nodiscard]] std::string colouring() const { return m_cells.colouring() ? m_cells.colouring()->id : std::string(); }

    /// The height of the whole picture for a given width. It does not depend on the frame, so that the layout is stable while
    /// the camera moves.
    [[nodiscard]] double neededHeight(double width, const QFontMetricsF& metrics) const;
    /// The layout of the map in a rectangle.
    [[nodiscard]] MapLayout layout(const QRectF& place, const QFontMetricsF& metrics) const;
    /// Paints the map. The contents must not be empty. The cursor is painted in windows only.
    void paint(QPainter& painter, const QRectF& place, const QPalette& palette,
               const std::optional<SphericalGrid::Cell>& cursor = {}) const;

    /// What a brief map leaves to another legend: the lines and marks that it has, and the states whose colours it has.
    [[nodiscard]] std::vector<MapLegend::Entry> lines() const;
    [[nodiscard]] std::vector<TriangleState> states() const;
    /// The meaning of its tones, with the unit; empty where the cells have the colours of states.
    [[nodiscard]] QString scaleWords() const;

    /// The colour of a cell from the middle of the scale under the veil, as the legend shows it.
    [[nodiscard]] QColor veiledColour(const QPalette& palette) const;

private:
    void paintCaption(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    /// The layout of a brief map whose caption stands beside it: where its height alone limits the map, which would have half the
    /// size below its caption. None: the caption stands above.
    [[nodiscard]] std::optional<MapLayout> layoutBesideCaption(const QRectF& place, const QFontMetricsF& metrics) const;
    static void paintAxes(QPainter& painter, const MapLayout& layout, const MapColours& colours);
    /// The height of the map's lines of text between scale and legend.
    [[nodiscard]] double wordsHeight(const QFontMetricsF& metrics) const;
    void paintWords(QPainter& painter, const QRectF& place, const MapColours& colours) const;
    void paintScale(QPainter& painter, const QRectF& place, const QPalette& palette) const;
    /// The legend below map and scale.
    [[nodiscard]] MapLegend legend(const QFontMetricsF& metrics, const QPalette& palette) const;
    [[nodiscard]] double heightBelow(double width, const QFontMetricsF& metrics) const;
    [[nodiscard]] std::vector<MapLegend::Entry> statesShown(const QPalette& palette) const;

    /// A brief caption that is wider than the map's place has a second line.
    [[nodiscard]] int captionLines(double width, const QFontMetricsF& metrics) const;
    /// Of all its lines.
    [[nodiscard]] double captionHeight(double width, const QFontMetricsF& metrics) const;

    CellPicture m_cells;
    bool m_brief = false;
};

}  // namespace cullscope::ui
