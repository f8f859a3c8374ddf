#pragma once

#include "core/raster/screen_triangle.h"
#include "core/raster/vectors.h"

// The inner loops of the depth buffer, compiled once for every instruction set. Every instruction set does the same operations in
// the same order, so that the pictures are bit-identical. Each has one source file that includes this, hence the anonymous
// namespace; screen_triangle.h says what must not be included here.

namespace cullscope {
namespace {

struct PixelCounters {
    Ints comparisons{};
    Ints written{};
    uint64_t blockComparisons = 0, blockWritten = 0;  ///< where whole blocks are counted
};

/// Draws eight pixels of a row where `covered` is −1 (and not 0). `columns`: of the first of them from the triangle's first
/// column.
template <typename Lanes>
inline void drawEight(const ScreenTriangle& triangle, double rowDepth, int32_t columns, const Ints& covered, float* depthAt,
                      uint32_t* numberAt, PixelCounters& counters) {
    const Doubles first = Doubles{0, 1, 2, 3} + double(columns), second = Doubles{4, 5, 6, 7} + double(columns);
    const HalfFloats left = __builtin_convertvector(rowDepth + triangle.depthPerColumn * first, HalfFloats);
    const HalfFloats right = __builtin_convertvector(rowDepth + triangle.depthPerColumn * second, HalfFloats);
    const Floats depth = __builtin_shufflevector(left, right, 0, 1, 2, 3, 4, 5, 6, 7);
    Floats before;
    load(before, depthAt);
    const Ints pass = (depth > before) & covered;
    counters.comparisons -= covered;
    if (Lanes::none(pass)) return;
    counters.written -= pass;
    Numbers numbers;
    load(numbers, numberAt);
    store<Floats>(depthAt, pass ? depth : before);
    store<Numbers>(numberAt, pass ? Numbers{} + triangle.number : numbers);
}

/// Whether a centre on the edge from corner i to the next one belongs to the triangle: a left edge goes down, one at the top goes
/// to the left.
inline bool ownsEdge(const ScreenTriangle& triangle, int i, int next) {
    return triangle.y[next] < triangle.y[i] || (triangle.y[next] == triangle.y[i] && triangle.x[next] < triangle.x[i]);
}

inline int64_t floorOf(int64_t dividend, int64_t divisor) {
    const int64_t quotient = dividend / divisor;
    return quotient - (quotient * divisor > dividend ? 1 : 0);
}

/// By rows: between its first and its last pixel a row of a triangle has no gap.
/// Other bands may say the same of the triangle at the same time.
inline void sayCovers(const RasterBand& band, uint32_t number) {
    __atomic_store_n(band.fates + (number - 1), uint8_t(kCovers), __ATOMIC_RELAXED);
}

template <typename Lanes>
inline void drawSetUp(const ScreenTriangle& triangle, const RasterBand& band, PixelCounters& counters) {
    const int32_t firstRow = triangle.firstRow > band.firstRow ? triangle.firstRow : band.firstRow;
    const int32_t endRow = triangle.endRow < band.endRow ? triangle.endRow : band.endRow;
    for (int32_t row = firstRow; row < endRow; ++row) {
        int64_t begin = triangle.firstColumn, end = triangle.endColumn;
        for (int i = 0; i < 3; ++i) {
            const int next = i == 2 ? 0 : i + 1;
            const int64_t dx = triangle.x[next] - triangle.x[i], dy = triangle.y[next] - triangle.y[i];
            // The edge function at a column is atZero − dy · 256 · column.
            const int64_t atZero =
                dx * (int64_t(row) * kSubPixels - triangle.y[i]) + dy * triangle.x[i] - (ownsEdge(triangle, i, next) ? 0 : 1);
            const int64_t perColumn = -dy * kSubPixels;
            if (perColumn > 0) {
                const int64_t from = -floorOf(atZero, perColumn);
                begin = from > begin ? from : begin;
            } else if (perColumn < 0) {
                const int64_t to = floorOf(atZero, -perColumn) + 1;
                end = to < end ? to : end;
            } else if (atZero < 0) {
                end = begin;
            }
        }
        if (begin < end) sayCovers(band, triangle.number);
        const size_t start = size_t(row - band.firstRow) * band.stride;
        const double rowDepth = triangle.depth + triangle.depthPerRow * double(row - triangle.firstRow);
        for (int64_t column = begin & ~int64_t(kLanes - 1); column < end; column += kLanes) {
            const Ints columns = Ints{0, 1, 2, 3, 4, 5, 6, 7} + int32_t(column);
            const Ints covered = (columns >= int32_t(begin)) & (columns < int32_t(end));
            drawEight<Lanes>(triangle, rowDepth, int32_t(column) - triangle.firstColumn, covered,
                             band.depth + start + size_t(column), band.number + start + size_t(column), counters);
        }
    }
}

// ---- Small triangles

/// Small triangles, eight to a register while they are set up; of each the same numbers as in a ScreenTriangle.
struct Batch {
    static constexpr size_t kMost = 64;
    alignas(32) int32_t x[3][kMost], y[3][kMost];
    alignas(32) float z[3][kMost];
    alignas(32) uint32_t number[kMost];
    size_t count = 0;
    // What is drawn in the band: blocks of four columns and four rows.
    alignas(32) int32_t column[kMost], endColumn[kMost], row[kMost], endRow[kMost];
    /// By edge: its function at the first block's first pixel, and its change by column and row.
    alignas(32) int32_t edge[3][kMost], perColumn[3][kMost], perRow[3][kMost];
    /// How far the first block lies from the triangle's first column and row.
    alignas(32) int32_t fromColumn[kMost], fromRow[kMost];
    alignas(32) double depth[kMost], depthPerColumn[kMost], depthPerRow[kMost];
};

// In the arrays of a batch.
using AlignedInts = int32_t __attribute__((vector_size(32), may_alias));
using AlignedFloats = float __attribute__((vector_size(32), may_alias));
using AlignedDoubles = double __attribute__((vector_size(32), may_alias));

inline AlignedInts& eight(int32_t* values) { return *reinterpret_cast<AlignedInts*>(values); }
inline AlignedFloats& eight(float* values) { return *reinterpret_cast<AlignedFloats*>(values); }
inline AlignedDoubles& four(double* values) { return *reinterpret_cast<AlignedDoubles*>(values); }
inline Ints lower(const Ints& a, const Ints& b) { return a < b ? a : b; }
inline Ints higher(const Ints& a, const Ints& b) { return a > b ? a : b; }
inline Doubles halfOf(const Ints& values, bool second) {
    const HalfInts half =
        second ? __builtin_shufflevector(values, values, 4, 5, 6, 7) : __builtin_shufflevector(values, values, 0, 1, 2, 3);
    return __builtin_convertvector(half, Doubles);
}
inline Doubles halfOf(const Floats& values, bool second) {
    const HalfFloats half =
        second ? __builtin_shufflevector(values, values, 4, 5, 6, 7) : __builtin_shufflevector(values, values, 0, 1, 2, 3);
    return __builtin_convertvector(half, Doubles);
}

/// Eight triangles while they are set up.
struct EightTriangles {
    Ints x[3], y[3];
    Floats z[3];
    Ints area, firstColumn, firstRow;
};

/// Their depths as functions of column and row, by the operations of a ScreenTriangle in the same order.
inline void setUpDepths(const EightTriangles& of, size_t first, Batch& batch) {
    for (size_t half = 0; half < 8; half += 4) {
        const bool second = half != 0;
        Doubles x[3], y[3];
        for (int i = 0; i < 3; ++i) {
            x[i] = halfOf(of.x[i], second);
            y[i] = halfOf(of.y[i], second);
        }
        const Doubles z = halfOf(of.z[0], second), toSecond = halfOf(of.z[1], second) - z, toThird = halfOf(of.z[2], second) - z;
        const Doubles toPixels = double(kSubPixels) / halfOf(of.area, second);
        const Doubles perColumn = (toSecond * (y[2] - y[0]) - toThird * (y[1] - y[0])) * toPixels;
        const Doubles perRow = (toThird * (x[1] - x[0]) - toSecond * (x[2] - x[0])) * toPixels;
        constexpr double kPixel = 1.0 / kSubPixels;
        const size_t at = first + half;
        four(&batch.depth[at]) = z + perColumn * (halfOf(of.firstColumn, second) - x[0] * kPixel) +
                                 perRow * (halfOf(of.firstRow, second) - y[0] * kPixel);
        four(&batch.depthPerColumn[at]) = perColumn;
        four(&batch.depthPerRow[at]) = perRow;
    }
}

/// Sets up eight triangles of the batch: counter-clockwise corners, boxes, edges and depths.
inline void setUpEight(Batch& batch, size_t first, const RasterBand& band) {
    EightTriangles of;
    for (int i = 0; i < 3; ++i) {
        of.x[i] = eight(&batch.x[i][first]);
        of.y[i] = eight(&batch.y[i][first]);
        of.z[i] = eight(&batch.z[i][first]);
    }
    auto& [x, y, z, area, firstColumn, firstRow] = of;
    area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
    const Ints turned = area < 0;
    area = turned ? -area : area;
    const auto turn = [&turned](auto& second, auto& third) {
        const auto was = second;
        second = turned ? third : second;
        third = turned ? was : third;
    };
    turn(x[1], x[2]);
    turn(y[1], y[2]);
    turn(z[1], z[2]);
    const Ints none{};
    firstColumn = higher((lower(lower(x[0], x[1]), x[2]) + (kSubPixels - 1)) >> 8, none);
    const Ints endColumn = lower((higher(higher(x[0], x[1]), x[2]) >> 8) + 1, none + band.width);
    firstRow = higher((lower(lower(y[0], y[1]), y[2]) + (kSubPixels - 1)) >> 8, none);
    const Ints endRow = lower((higher(higher(y[0], y[1]), y[2]) >> 8) + 1, none + band.endRow);
    setUpDepths(of, first, batch);
    // Blocks must not reach beyond the row's samples, nor beyond the band: there they begin earlier, where no pixel is inside.
    const Ints column = lower(firstColumn, int32_t(band.stride) - ((endColumn - firstColumn + 3) & ~3));
    Ints row = higher(firstRow, none + band.firstRow);
    row = lower(row, band.endOfRows - ((endRow - row + 3) & ~3));
    eight(&batch.column[first]) = column;
    eight(&batch.endColumn[first]) = endColumn;
    eight(&batch.row[first]) = row;
    eight(&batch.endRow[first]) = endRow;
    eight(&batch.fromColumn[first]) = column - firstColumn;
    eight(&batch.fromRow[first]) = row - firstRow;
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        const Ints dx = x[next] - x[i], dy = y[next] - y[i];
        // A centre on a left edge, or on one at the top, belongs to the triangle (ownsEdge); else it must lie beyond it.
        const Ints owned = (dy < 0) | ((dy == 0) & (dx < 0));
        eight(&batch.edge[i][first]) = dx * (row * kSubPixels - y[i]) - dy * (column * kSubPixels - x[i]) - (owned + 1);
        eight(&batch.perColumn[i][first]) = dy * -kSubPixels;
        eight(&batch.perRow[i][first]) = dx * kSubPixels;
    }
}

/// Two rows of a block: where the triangle covers it, samples are compared and those that are nearer written.
inline void drawRows(const Ints& covered, const HalfFloats& low, const HalfFloats& high, const Numbers& number, size_t at,
                     const RasterBand& band, PixelCounters& counters) {
    float *const depths = band.depth + at, *const depthsAbove = depths + band.stride;
    uint32_t *const numbers = band.number + at, *const numbersAbove = numbers + band.stride;
    HalfFloats lowBefore, highBefore;
    load(lowBefore, depths);
    load(highBefore, depthsAbove);
    HalfNumbers lowNumbers, highNumbers;
    load(lowNumbers, numbers);
    load(highNumbers, numbersAbove);
    const Floats depth = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
    const Floats before = __builtin_shufflevector(lowBefore, highBefore, 0, 1, 2, 3, 4, 5, 6, 7);
    const Ints pass = (depth > before) & covered;
    counters.comparisons -= covered;
    counters.written -= pass;
    const Floats after = pass ? depth : before;
    const Numbers shown = pass ? number : __builtin_shufflevector(lowNumbers, highNumbers, 0, 1, 2, 3, 4, 5, 6, 7);
    store<HalfFloats>(depths, __builtin_shufflevector(after, after, 0, 1, 2, 3));
    store<HalfFloats>(depthsAbove, __builtin_shufflevector(after, after, 4, 5, 6, 7));
    store<HalfNumbers>(numbers, __builtin_shufflevector(shown, shown, 0, 1, 2, 3));
    store<HalfNumbers>(numbersAbove, __builtin_shufflevector(shown, shown, 4, 5, 6, 7));
}

/// A block of a triangle of the batch: four columns and four rows.
struct BlockPlace {
    int32_t column, row;
    int32_t right, up;  ///< from the triangle's first block
    size_t at;          ///< of the first sample in the band
};

/// Draws a block with registers of eight numbers.
template <typename Lanes>
inline void drawBlock(const Batch& batch, size_t i, const BlockPlace& block, const RasterBand& band, PixelCounters& counters) {
    const Ints columnOf{0, 1, 2, 3, 0, 1, 2, 3}, rowOf{0, 0, 0, 0, 1, 1, 1, 1};
    const Doubles steps{0, 1, 2, 3};
    const Ints columns = columnOf + block.right, rows = rowOf + block.up;
    const Ints edge0 = columns * batch.perColumn[0][i] + rows * batch.perRow[0][i] + batch.edge[0][i];
    const Ints edge1 = columns * batch.perColumn[1][i] + rows * batch.perRow[1][i] + batch.edge[1][i];
    const Ints edge2 = columns * batch.perColumn[2][i] + rows * batch.perRow[2][i] + batch.edge[2][i];
    // Below 0 beyond the box's last column or row, as an edge function.
    const Ints columnsLeft = (batch.endColumn[i] - block.column - 1) - columnOf;
    const Ints rowsLeft = (batch.endRow[i] - block.row - 1) - rowOf;
    const Ints lower = ~((edge0 | edge1 | edge2 | columnsLeft | rowsLeft) >> 31);
    const Ints upper = ~(((edge0 + 2 * batch.perRow[0][i]) | (edge1 + 2 * batch.perRow[1][i]) | (edge2 + 2 * batch.perRow[2][i]) |
                          columnsLeft | (rowsLeft - 2)) >>
                         31);
    if (Lanes::none(lower | upper)) return;
    sayCovers(band, batch.number[i]);
    const Numbers number = Numbers{} + batch.number[i];
    const Doubles along = batch.depthPerColumn[i] * (steps + double(batch.fromColumn[i] + block.right));
    const Doubles depths = batch.depth[i] + batch.depthPerRow[i] * (steps + double(batch.fromRow[i] + block.up));
    drawRows(lower, __builtin_convertvector(depths[0] + along, HalfFloats),
             __builtin_convertvector(depths[1] + along, HalfFloats), number, block.at, band, counters);
    drawRows(upper, __builtin_convertvector(depths[2] + along, HalfFloats),
             __builtin_convertvector(depths[3] + along, HalfFloats), number, block.at + 2 * band.stride, band, counters);
}

/// Draws a triangle of the batch by its edge functions, block by block: inside where all three are at least 0. Most triangles lie
/// in one block, so that nothing is worth a branch but that they cover no sample at all.
template <typename Lanes>
inline void drawSmall(const Batch& batch, size_t i, const RasterBand& band, PixelCounters& counters) {
    BlockPlace block{batch.column[i], batch.row[i], 0, 0,
                     size_t(batch.row[i] - band.firstRow) * band.stride + size_t(batch.column[i])};
    for (;;) {
        Lanes::drawBlock(batch, i, block, band, counters);
        block.column += 4;
        block.right += 4;
        block.at += 4;
        if (block.column < batch.endColumn[i]) continue;
        block.row += 4;
        if (block.row >= batch.endRow[i]) return;
        block.at += 4 * band.stride - size_t(block.right);
        block.column -= block.right;
        block.right = 0;
        block.up += 4;
    }
}

template <typename Lanes>
inline void drawBatch(Batch& batch, const RasterBand& band, PixelCounters& counters) {
    for (size_t i = batch.count; i % 8 != 0; ++i)
        for (int corner = 0; corner < 3; ++corner) batch.x[corner][i] = batch.y[corner][i] = 0;
    for (size_t i = 0; i < batch.count; i += 8) setUpEight(batch, i, band);
    PixelCounters own;
    for (size_t i = 0; i < batch.count; ++i) drawSmall<Lanes>(batch, i, band, own);
    counters.comparisons += own.comparisons;
    counters.written += own.written;
    counters.blockComparisons += own.blockComparisons;
    counters.blockWritten += own.blockWritten;
    batch.count = 0;
}

inline void addTo(RasterCounts& counts, PixelCounters& counters) {
    for (int lane = 0; lane < kLanes; ++lane) {
        counts.comparisons += uint64_t(counters.comparisons[lane]);
        counts.written += uint64_t(counters.written[lane]);
    }
    counts.comparisons += counters.blockComparisons;
    counts.written += counters.blockWritten;
    counters = {};
}

template <typename Lanes>
void drawTriangles(const PartInBand& part, const RasterBand& band, RasterCounts& counts) {
    Batch batch;
    PixelCounters counters;
    for (size_t entry = 0; entry < part.count; ++entry) {
        const uint16_t place = part.entries[entry];
        if ((place & kSetUp) != 0) {
            // In their order.
            drawBatch<Lanes>(batch, band, counters);
            drawSetUp<Lanes>(part.setUp[place & ~kSetUp], band, counters);
            // The lanes' counters are added up before a large picture could exceed 32 bits.
            addTo(counts, counters);
            continue;
        }
        for (int i = 0; i < 3; ++i) {
            const RasterVertex& corner = part.vertices[part.indices[3 * size_t(place) + size_t(i)]];
            batch.x[i][batch.count] = corner.x;
            batch.y[i][batch.count] = corner.y;
            batch.z[i][batch.count] = corner.depth;
        }
        batch.number[batch.count] = part.firstNumber + place;
        if (++batch.count == Batch::kMost) drawBatch<Lanes>(batch, band, counters);
    }
    drawBatch<Lanes>(batch, band, counters);
    addTo(counts, counters);
}

}  // namespace
}  // namespace cullscope
