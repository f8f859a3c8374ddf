#pragma once

#include <QPainter>
#include <optional>

#include "ui/families/spherical/map_cells.h"

namespace cullscope::ui {

/// The inputs of a map's picture.
struct MapContents {
    ShownMap shown;
    std::shared_ptr<const TriangleStates> truth;  ///< states of the shown scene's triangles; null: not known
    std::optional<uint32_t> picked;               ///< the picked triangle, numbered within the mesh
    std::optional<uint32_t> sector;               ///< sector of the contour bands whose edges are marked

    bool operator==(const MapContents&) const = default;
};

/// The cells of a map as an image, cached until contents, colouring or size change. In all colourings but by state, a
/// half-transparent veil covers the cells that the contour bands hide.
class CellPicture {
public:
    void setContents(const MapContents& contents);
    [[nodiscard]] const MapContents& contents() const { return m_contents; }
    void setColouring(spherical::MapColouring colouring);
    [[nodiscard]] spherical::MapColouring colouring() const { return m_colouring; }

    [[nodiscard]] const CellTones& tones() const;
    /// Whether the image has a veil.
    [[nodiscard]] bool veiled() const {
        return m_colouring != spherical::MapColouring::State && m_contents.shown.decision().bands;
    }
    void paint(QPainter& painter, const QRectF& area, const QPalette& palette, const QColor& veil) const;

private:
    void forgetCells();

    MapContents m_contents;
    spherical::MapColouring m_colouring = spherical::MapColouring::Entries;
    mutable std::optional<CellTones> m_tones;
    mutable QImage m_cells, m_veil;  ///< null: outdated, made in the next paint()
    mutable QList<QRgb> m_colours;   ///< colour table of m_cells
};

}  // namespace cullscope::ui
