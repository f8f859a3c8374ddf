#pragma once

#include <QPainter>
#include <optional>

#include "ui/panels/map_cells.h"

namespace cullscope::ui {

/// What a picture of a map shows.
struct MapContents {
    ShownMap shown;
    std::shared_ptr<const TriangleStates> truth;  ///< of the shown scene; null: not known
    std::optional<uint32_t> picked;               ///< triangle of the mesh
    std::optional<uint32_t> sector;               ///< of the decision's bands, whose edges are marked

    bool operator==(const MapContents&) const = default;
};

/// The cells of a map as an image, kept until contents, colouring or size change. Unless they are coloured by state, what the
/// contour bands hide lies under a veil.
class CellPicture {
public:
    void setContents(const MapContents& contents);
    [[nodiscard]] const MapContents& contents() const { return m_contents; }
    void setColouring(MapColouring colouring);
    [[nodiscard]] MapColouring colouring() const { return m_colouring; }

    [[nodiscard]] const CellTones& tones() const;
    /// Whether any cell is under the veil.
    [[nodiscard]] bool veiled() const { return m_colouring != MapColouring::State && m_contents.shown.decision().bands; }
    void paint(QPainter& painter, const QRectF& area, const QPalette& palette, const QColor& veil) const;

private:
    void forgetCells();

    MapContents m_contents;
    MapColouring m_colouring = MapColouring::Entries;
    mutable std::optional<CellTones> m_tones;
    mutable QImage m_cells, m_veil;  ///< null: to be made
    mutable QList<QRgb> m_colours;   ///< of m_cells
};

}  // namespace cullscope::ui
