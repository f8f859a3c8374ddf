#pragma once

#include <QImage>
#include <QPainter>
#include <QPalette>
#include <memory>
#include <vector>

#include "ui/plots/shown_map.h"

namespace cullscope::ui {

/// One tone per cell, from which images of any size are made.
struct CellTones {
    static constexpr size_t kTones = 256;

    std::vector<uint8_t> tones;  ///< by cell number; 0: empty cell, else 1 … 255
    Term least, most;            ///< values of the tones 1 and 255; not set for states

    /// The tone of a state. If several cells share a pixel, the largest tone is shown.
    [[nodiscard]] static uint8_t toneOf(TriangleState state);
};

/// The tones of a colouring by values.
[[nodiscard]] CellTones cellTones(const CellMap& map, const std::string& colouring);
/// The tones of states. `truth` holds the states of the shown scene's triangles: a cell takes the strongest state of
/// the triangles that it owns (wrongly culled before visible before drawn in vain). Null: drawn cells count as visible. A cell
/// that owns no triangle but is touched by some takes the tone of the cell that owns the farthest-out of these.
[[nodiscard]] CellTones stateTones(const ShownMap& shown, const TriangleStates* truth);
/// The tone of one cell by the triangles that it owns; 0: it owns none.
[[nodiscard]] uint8_t stateTone(const ShownMap& shown, const TriangleStates* truth, uint32_t cell);

/// One colour per tone; empty cells have the palette's base colour.
[[nodiscard]] QList<QRgb> toneColours(bool states, const QPalette& palette);
/// Paints a bar of the tones 1 to 255 from left to right.
void paintTones(QPainter& painter, const QRectF& bar, bool states, const QPalette& palette);

/// An image of the map, `size` in pixels. If several cells share a pixel, it shows their largest tone, so that no cell of that
/// tone disappears.
[[nodiscard]] QImage cellImage(const std::vector<uint8_t>& tones, const SphericalGrid& grid, const QSize& size,
                               const QList<QRgb>& colours);

}  // namespace cullscope::ui
