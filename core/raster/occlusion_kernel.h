#pragma once

#include "core/raster/occlusion_tiles.h"
#include "core/raster/vectors.h"

// The inner loops of the occlusion buffer, compiled once for every instruction set. They consist of the same operations in the
// same order for each, and none of them is fused: so the buffers are equal to the bit.

namespace cullscope {
namespace {

using Bytes = uint8_t __attribute__((vector_size(32)));

inline constexpr EightDoubles kRowsOfTile{0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr Numbers kLaneBits{1, 2, 4, 8, 16, 32, 64, 128};
inline constexpr Floats kLaneColumns{0, 1, 2, 3, 4, 5, 6, 7};
inline constexpr Floats kBlockColumn{0, 8, 16, 24, 0, 8, 16, 24};
inline constexpr Floats kBlockRow{0, 0, 0, 0, 4, 4, 4, 4};

/// An edge of a triangle: a pixel lies within it where atZero + perRow · row + perColumn · column is above 0. All are whole
/// numbers and a half, of whole numbers below 2^52, hence exact; a centre on an edge that the triangle owns lies within it.
struct OccluderEdge {
    double atZero, perRow;
    double perColumn;  ///< above 0: a left edge; 0: a horizontal one
    double columns;    ///< 1 / |perColumn|
};

inline void setUpEdges(const OccluderTriangle& triangle, OccluderEdge (&edges)[3]) {
    constexpr double kPixel = 256.0;
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        const double dx = double(triangle.x[next]) - triangle.x[i], dy = double(triangle.y[next]) - triangle.y[i];
        // A left edge goes down, one at the bottom goes to the right: these own the centres on them.
        const bool owns = dy < 0.0 || (dy == 0.0 && dx > 0.0);
        edges[i] = {dy * triangle.x[i] - dx * triangle.y[i] + (owns ? 0.5 : -0.5), kPixel * dx, -kPixel * dy,
                    dy == 0.0 ? 0.0 : 1.0 / (kPixel * (dy < 0.0 ? -dy : dy))};
    }
}

/// The pixels of the rows of a row of tiles that belong to a triangle: from `begin` to before `end`.
struct OccluderSpans {
    Ints begin, end;
};

inline void limit(EightDoubles& values, double least, double most) {
    values = values < least ? EightDoubles{} + least : values;
    values = values > most ? EightDoubles{} + most : values;
}

inline void spansOf(const OccluderTriangle& triangle, const OccluderEdge (&edges)[3], int32_t firstRow, OccluderSpans& spans) {
    spans.begin = Ints{} + triangle.firstColumn;
    spans.end = Ints{} + triangle.endColumn;
    const EightDoubles rows = kRowsOfTile + double(firstRow);
    for (const OccluderEdge& edge : edges) {
        const EightDoubles inRow = rows * edge.perRow + edge.atZero;
        // The edge crosses the row at a column whose distance from each whole number is at least half of `columns`, at least
        // 2^-32: more than the rounding of the product and of the sum. The sum is above 0, where a conversion rounds down.
        constexpr double kAbove = 65536.0;
        EightDoubles place = inRow * edge.columns;
        limit(place, -kAbove + 1.0, kAbove);
        const Ints whole = __builtin_convertvector(place + kAbove, Ints) - int32_t(kAbove);
        if (edge.perColumn > 0.0) {
            spans.begin = -whole > spans.begin ? -whole : spans.begin;
        } else if (edge.perColumn < 0.0) {
            spans.end = whole + 1 < spans.end ? whole + 1 : spans.end;
        } else {
            const EightDoubles outside = inRow > 0.0 ? EightDoubles{} : EightDoubles{} + 1.0;
            spans.end = __builtin_convertvector(outside, Ints) != 0 ? Ints{} : spans.end;
        }
    }
}

/// The pixels of a tile's rows as bits, the left one the lowest.
inline void bitsOf(const OccluderSpans& spans, int32_t column, Numbers& bits) {
    const Ints none{}, all = none + kOcclusionColumns;
    Ints low = spans.begin - column, high = spans.end - column;
    low = low < 0 ? none : low;
    high = high > all ? all : high;
    const Numbers ones = Numbers{} + 0xFFFFFFFFu;
    // Shifts by 32 are none; where a row is empty they are not used.
    const Numbers from = ones << (Numbers)(low & 31), to = ones >> (Numbers)((all - high) & 31);
    bits = low < high ? from & to : Numbers{};
}

// ---- Depths of pixels

inline void drawOn(const OccluderTriangle& triangle, const Numbers& bits, int32_t column, int32_t row, DepthTile& tile) {
    const float first = triangle.depth + triangle.perColumn * float(column);
    const Floats along = kLaneColumns * triangle.perColumn + first;
    for (int32_t i = 0; i < kOcclusionRows; ++i) {
        const uint32_t ofRow = bits[i];
        if (ofRow == 0) continue;
        const Floats inRow = along + triangle.perRow * float(row + i);
        for (int32_t eight = 0; eight < kOcclusionColumns; eight += kLanes) {
            const uint32_t ofEight = ofRow >> eight & 0xFF;
            if (ofEight == 0) continue;
            float* const pixels = tile.depth + i * kOcclusionColumns + eight;
            const Floats depth = inRow + triangle.perColumn * float(eight);
            Floats before;
            load(before, pixels);
            const Ints pass = ((kLaneBits & ofEight) != 0) & (depth > before);
            store<Floats>(pixels, pass ? depth : before);
        }
    }
}

// ---- Masked tiles

/// The rows of a tile as the masks of its blocks: four bytes of four rows each.
inline void blocksOf(const Numbers& rows, Numbers& blocks) {
    Bytes bytes;
    __builtin_memcpy(&bytes, &rows, sizeof bytes);
    const Bytes turned = __builtin_shufflevector(bytes, bytes, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 16, 20, 24,
                                                 28, 17, 21, 25, 29, 18, 22, 26, 30, 19, 23, 27, 31);
    __builtin_memcpy(&blocks, &turned, sizeof blocks);
}

/// Of a triangle: what its plane's least depth in a block is less than the one at the tile's first pixel.
struct BlockDepths {
    Floats offset;
};
inline void setUpBlocks(const OccluderTriangle& triangle, BlockDepths& depths) {
    const float alongRow = triangle.perColumn * float(kBlockColumns - 1), upward = triangle.perRow * float(kBlockRows - 1);
    const float least = (alongRow < 0.0f ? alongRow : 0.0f) + (upward < 0.0f ? upward : 0.0f);
    depths.offset = kBlockColumn * triangle.perColumn + kBlockRow * triangle.perRow + least;
}

/// Merges a triangle's pixels into a tile. Where these and the masked pixels make up a whole block, the farther of both depths is
/// the block's from now on, and the nearer one keeps its own pixels. Until then what the mask covers grows, and its depth moves
/// back to the farther of both; where that would lose more than forgetting the masked pixels does, these are forgotten.
inline void drawOn(const OccluderTriangle& triangle, const BlockDepths& depths, const Numbers& rows, int32_t column, int32_t row,
                   const Numbers& beyond, MaskedTile& tile) {
    Floats whole, part;
    Numbers mask, bits;
    load(whole, tile.whole);
    load(part, tile.part);
    load(mask, tile.mask);
    blocksOf(rows, bits);
    const float first = triangle.depth + triangle.perColumn * float(column) + triangle.perRow * float(row);
    Floats depth = depths.offset + first;
    depth = depth > triangle.farthest ? depth : Floats{} + triangle.farthest;
    // What lies behind the masked pixels and covers no others adds nothing.
    const Ints adds = ((bits & ~mask) != 0) | (depth > part);
    const Ints drawn = (bits != 0) & (depth > whole) & adds;
    bits = drawn ? bits | beyond : Numbers{};
    const Numbers all = Numbers{} + 0xFFFFFFFFu, either = mask | bits;
    // Without a masked pixel there is no depth that counts.
    const Ints alone = mask == 0, nearer = alone | (depth > part);
    const Ints full = drawn & (either == all), byItself = full & nearer & (bits == all);
    whole = full ? ((nearer & ~byItself) ? part : depth) : whole;
    // The triangle lies farther before the masked pixels than these before the whole block.
    const Ints forget = drawn & (depth - part > part - whole);
    const Ints replaces = drawn & (full ? nearer : (alone | forget)), merges = drawn & ~full & ~replaces;
    part = replaces ? depth : ((merges & ~nearer) ? depth : part);
    mask = replaces ? bits : (merges ? either : mask);
    mask = byItself ? Numbers{} : mask;
    store<Floats>(tile.whole, whole);
    store<Floats>(tile.part, part);
    store<Numbers>(tile.mask, mask);
}

/// The pixels of a tile that lie beyond the picture, as rows of bits.
inline void bitsBeyond(const OcclusionTiles& tiles, int32_t column, int32_t row, Numbers& bits) {
    const int32_t columns = tiles.width - column, rows = tiles.height - row;
    const uint32_t right = columns >= kOcclusionColumns ? 0u : 0xFFFFFFFFu << columns;
    for (int32_t i = 0; i < kOcclusionRows; ++i) bits[i] = i < rows ? right : 0xFFFFFFFFu;
}

/// Whether a triangle may lie before something of a tile: before the whole of one of its blocks, at least.
inline bool mayShow(const OccluderTriangle& triangle, const MaskedTile& tile) {
    Floats whole;
    load(whole, tile.whole);
    const Ints before = whole < triangle.nearest;
    uint64_t words[4];
    __builtin_memcpy(words, &before, sizeof words);
    return (words[0] | words[1] | words[2] | words[3]) != 0;
}

// ---- Triangles

/// Whether one of a row's masked tiles that a triangle reaches may show it. Of many tiles it is not looked for.
inline bool mayShowInRow(const OccluderTriangle& triangle, const MaskedTile* row) {
    const int32_t first = triangle.firstColumn / kOcclusionColumns, last = (triangle.endColumn - 1) / kOcclusionColumns;
    if (last - first > 3) return true;
    for (int32_t tile = first; tile <= last; ++tile)
        if (mayShow(triangle, row[tile])) return true;
    return false;
}

/// The columns from the first to before the last one in which rows have pixels. Empty rows count neither as the first nor as the
/// last one.
inline void columnsOf(const OccluderTriangle& triangle, const OccluderSpans& spans, int32_t& least, int32_t& most) {
    const Ints some = spans.begin < spans.end;
    Ints begin = some ? spans.begin : Ints{} + triangle.endColumn, end = some ? spans.end : Ints{} + triangle.firstColumn;
    const auto halve = [&](const Ints& otherBegin, const Ints& otherEnd) {
        begin = otherBegin < begin ? otherBegin : begin;
        end = otherEnd > end ? otherEnd : end;
    };
    halve(__builtin_shufflevector(begin, begin, 4, 5, 6, 7, 0, 1, 2, 3),
          __builtin_shufflevector(end, end, 4, 5, 6, 7, 0, 1, 2, 3));
    halve(__builtin_shufflevector(begin, begin, 2, 3, 0, 1, 2, 3, 0, 1),
          __builtin_shufflevector(end, end, 2, 3, 0, 1, 2, 3, 0, 1));
    halve(__builtin_shufflevector(begin, begin, 1, 0, 1, 0, 1, 0, 1, 0),
          __builtin_shufflevector(end, end, 1, 0, 1, 0, 1, 0, 1, 0));
    least = begin[0];
    most = end[0];
}

inline void drawOccluder(const OccluderTriangle& triangle, const OcclusionTiles& tiles) {
    OccluderEdge edges[3];
    BlockDepths depths;
    bool ready = false;
    for (int32_t row = triangle.firstRow & -kOcclusionRows; row < triangle.endRow; row += kOcclusionRows) {
        const size_t firstTile = size_t(row / kOcclusionRows) * size_t(tiles.tilesInRow);
        if (tiles.masked != nullptr && !mayShowInRow(triangle, tiles.masked + firstTile)) continue;
        // A third of the triangles lie behind the whole of all blocks that they reach.
        if (!ready) {
            setUpEdges(triangle, edges);
            setUpBlocks(triangle, depths);
            ready = true;
        }
        OccluderSpans spans;
        spansOf(triangle, edges, row, spans);
        int32_t least = 0, most = 0;
        columnsOf(triangle, spans, least, most);
        for (int32_t column = least & -kOcclusionColumns; column < most; column += kOcclusionColumns) {
            const size_t tile = firstTile + size_t(column / kOcclusionColumns);
            if (tiles.masked != nullptr && !mayShow(triangle, tiles.masked[tile])) continue;
            Numbers bits;
            bitsOf(spans, column, bits);
            if (tiles.depths != nullptr) {
                drawOn(triangle, bits, column, row, tiles.depths[tile]);
                tiles.farthest[tile] = kUnknownFarthest;
                continue;
            }
            Numbers beyond{};
            if (column + kOcclusionColumns > tiles.width || row + kOcclusionRows > tiles.height) {
                Numbers rowsBeyond;
                bitsBeyond(tiles, column, row, rowsBeyond);
                blocksOf(rowsBeyond, beyond);
            }
            drawOn(triangle, depths, bits, column, row, beyond, tiles.masked[tile]);
        }
    }
}

inline void drawAllOccluders(const OccluderTriangle* triangles, size_t count, const OcclusionTiles& tiles) {
    for (size_t i = 0; i < count; ++i) drawOccluder(triangles[i], tiles);
}

}  // namespace
}  // namespace cullscope
