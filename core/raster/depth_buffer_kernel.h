#pragma once

#include "core/raster/projection_kernel.h"

// The inner loops of the depth buffer, compiled once for every instruction set. Every instruction set does the same operations in
// the same order, so that the pictures are bit-identical. Each has one source file that includes this, hence the anonymous
// namespace; screen_triangle.h says what must not be included here.

namespace cullscope {
namespace {

inline Floats eightOf(float value) { return Floats{} + value; }

/// Two rows of a tile each.
using TileInts = Ints[2];
using TileFloats = Floats[2];

inline constexpr Ints kColumns{0, 1, 2, 3, 0, 1, 2, 3};
inline constexpr Ints kRows[2]{{0, 0, 0, 0, 1, 1, 1, 1}, {2, 2, 2, 2, 3, 3, 3, 3}};
inline constexpr Floats kFloatColumns{0, 1, 2, 3, 0, 1, 2, 3};
inline constexpr Floats kFloatRows[2]{{0, 0, 0, 0, 1, 1, 1, 1}, {2, 2, 2, 2, 3, 3, 3, 3}};

/// The depths of a triangle in a tile, of which `column` and `row` are the first ones.
template <typename Lanes>
inline void depthsIn(float depth, float perColumn, float perRow, int32_t column, int32_t row, TileFloats& depths) {
    const Floats along = Lanes::fused(eightOf(perColumn), kFloatColumns + float(column), eightOf(depth));
    for (int half = 0; half < 2; ++half) {
        const Floats unlimited = Lanes::fused(eightOf(perRow), kFloatRows[half] + float(row), along);
        depths[half] = unlimited > 1.0f ? Floats{} + 1.0f : unlimited;
    }
}

/// Compares a triangle's depths where `covered` is −1 (and not 0), and writes those that are nearer.
template <typename Lanes>
inline void drawTile(const TileInts& covered, const TileFloats& depths, uint32_t number, RasterTile& tile, RasterCounts& counts) {
    counts.comparisons += Lanes::countOf(covered);
    TileInts pass;
    for (int half = 0; half < 2; ++half) {
        Floats before;
        load(before, tile.depth + 8 * half);
        pass[half] = (depths[half] > before) & covered[half];
    }
    const uint32_t written = Lanes::countOf(pass);
    if (written == 0) return;
    counts.written += written;
    for (int half = 0; half < 2; ++half) {
        Floats before;
        Numbers numbers;
        load(before, tile.depth + 8 * half);
        load(numbers, tile.number + 8 * half);
        store<Floats>(tile.depth + 8 * half, pass[half] ? depths[half] : before);
        store<Numbers>(tile.number + 8 * half, pass[half] ? Numbers{} + number : numbers);
    }
}

/// Whether a tile reaches beyond the picture.
inline bool reachesBeyond(const RasterBand& band, int32_t column, int32_t row) {
    return column + kTile > band.width || row + kTile > band.endRow;
}

/// Whether a centre on the edge from corner i to the next one belongs to the triangle: a left edge goes down, one at the bottom
/// goes to the right.
inline bool ownsEdge(const ScreenTriangle& triangle, int i, int next) {
    return triangle.y[next] < triangle.y[i] || (triangle.y[next] == triangle.y[i] && triangle.x[next] > triangle.x[i]);
}

inline int64_t floorOf(int64_t dividend, int64_t divisor) {
    const int64_t quotient = dividend / divisor;
    return quotient - (quotient * divisor > dividend ? 1 : 0);
}

/// Other bands may say the same of the triangle at the same time.
inline void sayCovers(const RasterBand& band, uint32_t number) {
    __atomic_store_n(band.fates + (number - 1), uint8_t(kCovers), __ATOMIC_RELAXED);
}

/// The pixels of a row that belong to a triangle: between its first and its last one there is no gap.
inline void rowOf(const ScreenTriangle& triangle, int32_t row, int32_t& begin, int32_t& end) {
    int64_t first = triangle.firstColumn, last = triangle.endColumn;
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        const int64_t dx = triangle.x[next] - triangle.x[i], dy = triangle.y[next] - triangle.y[i];
        // The edge function at a column is atZero − dy · 256 · column.
        const int64_t atZero =
            dx * (int64_t(row) * kSubPixels - triangle.y[i]) + dy * triangle.x[i] - (ownsEdge(triangle, i, next) ? 0 : 1);
        const int64_t perColumn = -dy * kSubPixels;
        if (perColumn > 0) {
            const int64_t from = -floorOf(atZero, perColumn);
            first = from > first ? from : first;
        } else if (perColumn < 0) {
            const int64_t to = floorOf(atZero, -perColumn) + 1;
            last = to < last ? to : last;
        } else if (atZero < 0) {
            last = first;
        }
    }
    begin = int32_t(first);
    end = int32_t(last > first ? last : first);
}

template <typename Lanes>
inline void drawSetUp(const ScreenTriangle& triangle, const RasterBand& band, RasterCounts& counts) {
    const int32_t firstRow = triangle.firstRow > band.firstRow ? triangle.firstRow : band.firstRow;
    const int32_t endRow = triangle.endRow < band.endRow ? triangle.endRow : band.endRow;
    bool covers = false;
    for (int32_t row = firstRow & -kTile; row < endRow; row += kTile) {
        int32_t begin[kTile] = {}, end[kTile] = {}, least = triangle.endColumn, most = 0;
        for (int32_t i = 0; i < kTile; ++i) {
            if (row + i < firstRow || row + i >= endRow) continue;
            rowOf(triangle, row + i, begin[i], end[i]);
            if (begin[i] >= end[i]) continue;
            least = begin[i] < least ? begin[i] : least;
            most = end[i] > most ? end[i] : most;
        }
        if (least >= most) continue;
        covers = true;
        const Ints begins[2]{{begin[0], begin[0], begin[0], begin[0], begin[1], begin[1], begin[1], begin[1]},
                             {begin[2], begin[2], begin[2], begin[2], begin[3], begin[3], begin[3], begin[3]}};
        const Ints ends[2]{{end[0], end[0], end[0], end[0], end[1], end[1], end[1], end[1]},
                           {end[2], end[2], end[2], end[2], end[3], end[3], end[3], end[3]}};
        RasterTile* const tiles = band.tiles + size_t((row - band.firstRow) / kTile) * band.tilesInRow;
        for (int32_t column = least & -kTile; column < most; column += kTile) {
            TileInts covered;
            for (int half = 0; half < 2; ++half)
                covered[half] = (kColumns + column >= begins[half]) & (kColumns + column < ends[half]);
            TileFloats depths;
            depthsIn<Lanes>(triangle.depth, triangle.depthPerColumn, triangle.depthPerRow, column, row, depths);
            drawTile<Lanes>(covered, depths, triangle.number, tiles[column / kTile], counts);
        }
    }
    if (covers) sayCovers(band, triangle.number);
}

// ---- Small triangles

/// Small triangles of a part, eight to a register while they are set up; of each the same numbers as in a ScreenTriangle.
struct Batch {
    static constexpr size_t kMost = 64;
    uint16_t place[kMost];  ///< in the part
    size_t count = 0;
    alignas(32) uint32_t number[kMost];
    /// From the first tile that it reaches in the band.
    alignas(32) int32_t column[kMost], endColumn[kMost], row[kMost], endRow[kMost];
    /// By edge: its function at the first tile's first pixel, and its change by column and row.
    alignas(32) int32_t edge[3][kMost], perColumn[3][kMost], perRow[3][kMost];
    alignas(32) float depth[kMost], depthPerColumn[kMost], depthPerRow[kMost];
};

// In the arrays of a batch.
using AlignedInts = int32_t __attribute__((vector_size(32), may_alias));
using AlignedFloats = float __attribute__((vector_size(32), may_alias));

inline AlignedInts& eight(int32_t* values) { return *reinterpret_cast<AlignedInts*>(values); }
inline AlignedFloats& eight(float* values) { return *reinterpret_cast<AlignedFloats*>(values); }
/// Their depths as functions of column and row, by the operations of screenTriangle in the same order.
inline void setUpDepths(const EightCorners (&corners)[3], const Ints& clockwise, size_t first, Batch& batch) {
    const auto chosen = [&clockwise](const Floats& one, const Floats& other) -> Floats { return clockwise ? one : other; };
    const Floats x = chosen(corners[0].x, corners[1].x), y = chosen(corners[0].y, corners[1].y);
    const Floats z = chosen(corners[0].depth, corners[1].depth);
    const Floats xToP = x - chosen(corners[1].x, corners[0].x), yToP = y - chosen(corners[1].y, corners[0].y);
    const Floats xToR = corners[2].x - x, yToR = corners[2].y - y;
    const Floats toPlane = 1.0f / (xToP * yToR - yToP * xToR);
    const Floats xToPScaled = xToP * toPlane, yToPScaled = yToP * toPlane;
    const Floats xToRScaled = xToR * toPlane, yToRScaled = yToR * toPlane;
    const Floats depthToP = z - chosen(corners[1].depth, corners[0].depth), depthToR = corners[2].depth - z;
    const Floats perColumn = depthToP * yToRScaled - depthToR * yToPScaled;
    const Floats perRow = depthToR * xToPScaled - depthToP * xToRScaled;
    const Floats depth = z - (perColumn * (x - 0.5f) + perRow * (y - 0.5f));
    const auto absolute = [](const Floats& value) -> Floats { return value < 0.0f ? -value : value; };
    const Ints finite = absolute(depth) + absolute(perColumn) + absolute(perRow) < __builtin_inff();
    eight(&batch.depth[first]) = finite ? depth : eightOf(__builtin_nanf(""));
    eight(&batch.depthPerColumn[first]) = perColumn;
    eight(&batch.depthPerRow[first]) = perRow;
}

/// Sets up eight triangles of the batch: counter-clockwise corners, boxes, edges and depths.
template <typename Lanes>
inline void setUpEight(const PartInBand& part, Batch& batch, size_t first, const RasterBand& band) {
    EightCorners corners[3];
    Ints x[3], y[3];
    for (size_t i = 0; i < 3; ++i) loadCorners(part, batch.place + first, i, corners[i]);
    snapCorners<Lanes>(corners, x, y);
    const Ints area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const Ints clockwise = area < 0;
    setUpDepths(corners, clockwise, first, batch);
    const auto turn = [&clockwise](Ints& second, Ints& third) {
        const Ints was = second;
        second = clockwise ? third : second;
        third = clockwise ? was : third;
    };
    turn(x[1], x[2]);
    turn(y[1], y[2]);
    const Ints none{};
    const Ints firstColumn = higher((lower(lower(x[0], x[1]), x[2]) + (kSubPixels - 1)) >> 8, none);
    const Ints endColumn = lower((higher(higher(x[0], x[1]), x[2]) >> 8) + 1, none + band.width);
    const Ints firstRow = higher((lower(lower(y[0], y[1]), y[2]) + (kSubPixels - 1)) >> 8, none);
    const Ints endRow = lower((higher(higher(y[0], y[1]), y[2]) >> 8) + 1, none + band.endRow);
    const Ints column = firstColumn & -kTile, row = higher(firstRow, none + band.firstRow) & -kTile;
    eight(&batch.column[first]) = column;
    eight(&batch.endColumn[first]) = endColumn;
    eight(&batch.row[first]) = row;
    eight(&batch.endRow[first]) = endRow;
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        const Ints dx = x[next] - x[i], dy = y[next] - y[i];
        // A centre on a left edge, or on one at the bottom, belongs to the triangle (ownsEdge); else it must lie beyond it.
        const Ints owned = (dy < 0) | ((dy == 0) & (dx > 0));
        eight(&batch.edge[i][first]) = dx * (row * kSubPixels - y[i]) - dy * (column * kSubPixels - x[i]) - (owned + 1);
        eight(&batch.perColumn[i][first]) = dy * -kSubPixels;
        eight(&batch.perRow[i][first]) = dx * kSubPixels;
    }
}

/// Draws a triangle of the batch by its edge functions, tile by tile: inside where all three are at least 0. Which tiles a
/// triangle covers, and where it is nearer, is chance: nothing branches on it.
template <typename Lanes>
inline void drawSmallByHalves(const Batch& batch, size_t i, const RasterBand& band, RasterCounts& counts) {
    const int32_t firstColumn = batch.column[i], endColumn = batch.endColumn[i], endRow = batch.endRow[i];
    const int32_t width = band.width, endOfBand = band.endRow;
    const Floats depth = eightOf(batch.depth[i]), depthPerColumn = eightOf(batch.depthPerColumn[i]),
                 depthPerRow = eightOf(batch.depthPerRow[i]);
    const Numbers number = Numbers{} + batch.number[i];
    Ints perTile[3];
    TileInts ofRow[3];
    for (int e = 0; e < 3; ++e) {
        perTile[e] = Ints{} + kTile * batch.perColumn[e][i];
        for (int half = 0; half < 2; ++half)
            ofRow[e][half] = kColumns * batch.perColumn[e][i] + kRows[half] * batch.perRow[e][i] + batch.edge[e][i];
    }
    Ints comparisons{}, written{};  // each −1
    for (int32_t row = batch.row[i]; row < endRow; row += kTile) {
        RasterTile* tile = band.tiles + size_t((row - band.firstRow) / kTile) * band.tilesInRow + firstColumn / kTile;
        const TileFloats rows{kFloatRows[0] + float(row), kFloatRows[1] + float(row)};
        Floats columns = kFloatColumns + float(firstColumn);
        TileInts edge[3];
        __builtin_memcpy(&edge, &ofRow, sizeof edge);
        for (int32_t column = firstColumn; column < endColumn; column += kTile, ++tile, columns += float(kTile)) {
            TileInts covered;
            for (int half = 0; half < 2; ++half) {
                covered[half] = ~((edge[0][half] | edge[1][half] | edge[2][half]) >> 31);
                for (int e = 0; e < 3; ++e) edge[e][half] += perTile[e];
            }
            if (column + kTile > width || row + kTile > endOfBand)
                for (int half = 0; half < 2; ++half)
                    covered[half] &= (kColumns + column < width) & (kRows[half] + row < endOfBand);
            const Floats along = Lanes::fused(depthPerColumn, columns, depth);
            for (int half = 0; half < 2; ++half) {
                const Floats here = Lanes::atMostOne(Lanes::fused(depthPerRow, rows[half], along));
                Floats before;
                Numbers numbers;
                load(before, tile->depth + 8 * half);
                load(numbers, tile->number + 8 * half);
                const Ints pass = (here > before) & covered[half];
                store<Floats>(tile->depth + 8 * half, Lanes::chosen(pass, here, before));
                store<Numbers>(tile->number + 8 * half, Numbers(Lanes::chosen(pass, Floats(number), Floats(numbers))));
                comparisons += covered[half];
                written += pass;
            }
        }
        for (int e = 0; e < 3; ++e)
            for (int half = 0; half < 2; ++half) ofRow[e][half] += kTile * batch.perRow[e][i];
    }
    const auto sumOf = [](const Ints& ofLanes) {
        int32_t sum = 0;
        for (int lane = 0; lane < kLanes; ++lane) sum -= ofLanes[lane];
        return uint32_t(sum);
    };
    const uint32_t compared = sumOf(comparisons);
    if (compared == 0) return;
    counts.comparisons += compared;
    counts.written += sumOf(written);
    sayCovers(band, batch.number[i]);
}

template <typename Lanes>
inline void drawBatch(const PartInBand& part, Batch& batch, const RasterBand& band, RasterCounts& counts) {
    if (batch.count == 0) return;
    // What fills the last register is set up too, and not drawn.
    for (size_t i = batch.count; i % 8 != 0; ++i) batch.place[i] = batch.place[0];
    for (size_t i = 0; i < batch.count; ++i) batch.number[i] = part.firstNumber + batch.place[i];
    for (size_t i = 0; i < batch.count; i += 8) setUpEight<Lanes>(part, batch, i, band);
    RasterCounts own{};
    for (size_t i = 0; i < batch.count; ++i) Lanes::drawSmall(batch, i, band, own);
    counts.comparisons += own.comparisons;
    counts.written += own.written;
    batch.count = 0;
}

template <typename Lanes>
void drawTriangles(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    Batch batch;
    for (size_t entry = 0; entry < part.count; ++entry) {
        const uint16_t place = part.entries[entry];
        if ((place & kSetUp) != 0) {
            // In their order.
            drawBatch<Lanes>(part, batch, band, counts);
            drawSetUp<Lanes>(part.setUp[place & ~kSetUp], band, counts);
            continue;
        }
        batch.place[batch.count] = place;
        if (++batch.count == Batch::kMost) drawBatch<Lanes>(part, batch, band, counts);
    }
    drawBatch<Lanes>(part, batch, band, counts);
}

}  // namespace
}  // namespace cullscope
