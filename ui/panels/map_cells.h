#pragma once

#include <QImage>
#include <QPalette>
#include <memory>
#include <vector>

#include "core/image/map_picture.h"
#include "core/visibility/triangle_states.h"
#include "ui/panels/shown_map.h"

namespace cullscope::ui {

/// One tone a cell, from which pictures of any size are made.
struct CellTones {
    static constexpr size_t kTones = 256;

    std::vector<uint8_t> tones;      ///< by cell number; 0: empty, else 1 … 255
    double least = 0.0, most = 0.0;  ///< the values of tones 1 and 255; not of State

    /// Of State: a larger tone lies over a smaller one where several cells share a pixel.
    [[nodiscard]] static uint8_t toneOf(TriangleState state);
};

/// Of a colouring but State.
[[nodiscard]] CellTones cellTones(const spherical::MapSnapshot& map, MapColouring colouring);
/// Of State. `truth`, where known, are the states of the shown scene's triangles: a cell is as the worst triangle that it owns
/// (wrongly culled before visible before drawn in vain); null: drawn cells count as visible. A cell that owns none but is touched
/// by some is as the cell that owns the farthest-out of those.
[[nodiscard]] CellTones stateTones(const ShownMap& shown, const TriangleStates* truth);
/// The same of one cell; 0: it owns none.
[[nodiscard]] uint8_t stateTone(const ShownMap& shown, const TriangleStates* truth, uint32_t cell);

/// A colour a tone, on the palette's base, which itself stands for empty cells.
[[nodiscard]] QList<QRgb> toneColours(MapColouring colouring, const QPalette& palette);

/// A picture of the map, `size` in pixels. Where several cells share a pixel, it has the largest tone of them: nothing is lost.
[[nodiscard]] QImage cellImage(const std::vector<uint8_t>& tones, const SphericalGrid& grid, const QSize& size,
                               const QList<QRgb>& colours);

}  // namespace cullscope::ui
