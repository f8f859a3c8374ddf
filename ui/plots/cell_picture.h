#pragma once

#include <QPainter>
#include <optional>

#include "ui/plots/map_cells.h"

namespace cullscope::ui {

/// The inputs of a map's picture.
struct MapContents {
    ShownMap shown;
    std::shared_ptr<const TriangleStates> truth;  ///< states of the shown scene's triangles; null: not known
    std::optional<uint32_t> picked;               ///< the picked triangle, numbered within the mesh
    std::optional<uint32_t> part;                 ///< the part whose edges are marked, from 1
    std::vector<std::vector<Vec2>> inHand{};      ///< around the subject in hand of a stepped view, as MapCurve::points

    bool operator==(const MapContents&) const = default;
};

/// The cells of a map as an image, cached until contents, colouring or size change. In all colourings but by state, a
/// half-transparent veil covers the hidden cells of a map that asks for it.
class CellPicture {
public:
    void setContents(const MapContents& contents);
    [[nodiscard]] const MapContents& contents() const { return m_contents; }
    /// By the id of a colouring; where the map has none of that id, its first one is shown.
    /// Returns whether another one was chosen before.
    bool setColouring(const std::string& colouring);
    /// Null: there is no map, or it has no colouring.
    [[nodiscard]] const MapColouring* colouring() const;
    /// Whether cells are coloured by state.
    [[nodiscard]] bool byState() const { return colouring() && colouring()->states; }

    [[nodiscard]] const CellTones& tones() const;
    /// Whether the image has a veil.
    [[nodiscard]] bool veiled() const { return !byState() && m_contents.shown.map->veiled; }
    void paint(QPainter& painter, const QRectF& area, const QPalette& palette, const QColor& veil) const;

private:
    void forgetCells();

    MapContents m_contents;
    std::string m_colouring;
    mutable std::optional<CellTones> m_tones;
    mutable QImage m_cells, m_veil;  ///< null: outdated, made in the next paint()
    mutable QList<QRgb> m_colours;   ///< colour table of m_cells
};

}  // namespace cullscope::ui
