#pragma once

#include "core/raster/screen_triangle.h"

// The inner loops of the depth buffer, compiled once for every instruction set. Every instruction set does the same operations in
// the same order, so that the pictures are bit-identical. Each has one source file that includes this, hence the anonymous
// namespace; screen_triangle.h says what must not be included here.

namespace cullscope {
namespace {

// Eight pixels of a row. The compiler splits them where a register holds fewer.
using Floats = float __attribute__((vector_size(32)));
using Ints = int32_t __attribute__((vector_size(32)));
using Numbers = uint32_t __attribute__((vector_size(32)));
using Doubles = double __attribute__((vector_size(32)));
using HalfFloats = float __attribute__((vector_size(16)));
// The same in memory, where they may begin at any pixel.
using FloatsInMemory = float __attribute__((vector_size(32), aligned(4), may_alias));
using NumbersInMemory = uint32_t __attribute__((vector_size(32), aligned(4), may_alias));

/// Triangles up to this size have edge functions within 32 bits, also over the columns that a step of eight reaches beyond.
constexpr int32_t kSmall = 64 * kSubPixels;

struct PixelCounters {
    Ints comparisons{};
    Ints written{};
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
    const Floats before = *reinterpret_cast<const FloatsInMemory*>(depthAt);
    const Ints pass = (depth > before) & covered;
    counters.comparisons -= covered;
    if (Lanes::none(pass)) return;
    counters.written -= pass;
    const Numbers numbers = *reinterpret_cast<const NumbersInMemory*>(numberAt);
    *reinterpret_cast<FloatsInMemory*>(depthAt) = pass ? depth : before;
    *reinterpret_cast<NumbersInMemory*>(numberAt) = pass ? Numbers{} + triangle.number : numbers;
}

/// Whether a centre on the edge from corner i to the next one belongs to the triangle: a left edge goes down, one at the top goes
/// to the left.
inline bool ownsEdge(const ScreenTriangle& triangle, int i, int next) {
    return triangle.y[next] < triangle.y[i] || (triangle.y[next] == triangle.y[i] && triangle.x[next] < triangle.x[i]);
}

struct Rows {
    int32_t first, end;
};

/// By edge functions at every pixel of the triangle's box: inside where all three are at least 0.
template <typename Lanes>
inline void drawSmall(const ScreenTriangle& triangle, const Rows& rows, const RasterBand& band, PixelCounters& counters) {
    const int32_t firstColumn = triangle.firstColumn & ~(kLanes - 1);
    Ints rowEdge[3];
    int32_t perRow[3], perEight[3];
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        const int32_t dx = triangle.x[next] - triangle.x[i], dy = triangle.y[next] - triangle.y[i];
        const int32_t atFirst = dx * (rows.first * kSubPixels - triangle.y[i]) - dy * (firstColumn * kSubPixels - triangle.x[i]) -
                                (ownsEdge(triangle, i, next) ? 0 : 1);
        rowEdge[i] = Ints{0, 1, 2, 3, 4, 5, 6, 7} * (-dy * kSubPixels) + atFirst;
        perRow[i] = dx * kSubPixels;
        perEight[i] = -dy * kSubPixels * kLanes;
    }
    for (int32_t row = rows.first; row < rows.end; ++row) {
        const size_t start = size_t(row - band.firstRow) * band.stride;
        const double rowDepth = triangle.depth + triangle.depthPerRow * double(row - triangle.firstRow);
        Ints edge[3] = {rowEdge[0], rowEdge[1], rowEdge[2]};
        for (int32_t column = firstColumn; column < triangle.endColumn; column += kLanes) {
            Ints covered = (edge[0] | edge[1] | edge[2]) >= 0;
            // Beyond the picture's last column there is nothing to count.
            if (column + kLanes > triangle.endColumn) covered &= Ints{0, 1, 2, 3, 4, 5, 6, 7} < triangle.endColumn - column;
            if (!Lanes::none(covered))
                drawEight<Lanes>(triangle, rowDepth, column - triangle.firstColumn, covered, band.depth + start + column,
                                 band.number + start + column, counters);
            for (int i = 0; i < 3; ++i) edge[i] += perEight[i];
        }
        for (int i = 0; i < 3; ++i) rowEdge[i] += perRow[i];
    }
}

inline int64_t floorOf(int64_t dividend, int64_t divisor) {
    const int64_t quotient = dividend / divisor;
    return quotient - (quotient * divisor > dividend ? 1 : 0);
}

/// By rows: between its first and its last pixel a row of a triangle has no gap.
template <typename Lanes>
inline void drawLarge(const ScreenTriangle& triangle, const Rows& rows, const RasterBand& band, PixelCounters& counters) {
    for (int32_t row = rows.first; row < rows.end; ++row) {
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

inline bool isSmall(const int32_t (&corners)[3]) {
    const int32_t low = corners[0] < corners[1] ? corners[0] : corners[1];
    const int32_t high = corners[0] < corners[1] ? corners[1] : corners[0];
    return (corners[2] > high ? corners[2] : high) - (corners[2] < low ? corners[2] : low) <= kSmall;
}

template <typename Lanes>
void drawTriangles(const ScreenTriangle* const* triangles, size_t count, const RasterBand& band, RasterCounts& counts) {
    // The lanes' counters are added up before a large picture could exceed 32 bits.
    constexpr size_t kTogether = 256;
    for (size_t begin = 0; begin < count; begin += kTogether) {
        PixelCounters counters;
        for (size_t i = begin; i < count && i < begin + kTogether; ++i) {
            const ScreenTriangle& triangle = *triangles[i];
            const Rows rows{triangle.firstRow > band.firstRow ? triangle.firstRow : band.firstRow,
                            triangle.endRow < band.endRow ? triangle.endRow : band.endRow};
            if (isSmall(triangle.x) && isSmall(triangle.y))
                drawSmall<Lanes>(triangle, rows, band, counters);
            else
                drawLarge<Lanes>(triangle, rows, band, counters);
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            counts.comparisons += uint64_t(counters.comparisons[lane]);
            counts.written += uint64_t(counters.written[lane]);
        }
    }
}

}  // namespace
}  // namespace cullscope
