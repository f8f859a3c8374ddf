#pragma once

#include "core/raster/screen_triangle.h"
#include "core/raster/vectors.h"

// Brings vertices to the raster, eight at a time, as Projection does one, and says where triangles lie on it. Compiled once for
// every instruction set, as the depth buffer's kernels.

namespace cullscope {
namespace {

/// One coordinate of eight positions.
inline Floats coordinatesOf(const float* positions) {
    const Floats eight{positions[0],  positions[3],  positions[6],  positions[9],
                       positions[12], positions[15], positions[18], positions[21]};
    return eight;
}

template <typename Lanes>
void projectEight(const RasterProjection& projection, const float* positions, RasterVertex* vertices) {
    const Floats x = coordinatesOf(positions), y = coordinatesOf(positions + 1), z = coordinatesOf(positions + 2);
    Floats clip[4];
    for (int axis = 0; axis < 4; ++axis)
        clip[axis] = ((projection.columns[0][axis] * x + projection.columns[1][axis] * y) + projection.columns[2][axis] * z) +
                     projection.columns[3][axis];
    const Floats px = clip[0], py = clip[1], pz = clip[2], w = clip[3];
    const auto absolute = [](const Floats& value) -> Floats { return value < 0.0f ? -value : value; };
    const Ints numbers = absolute(px) + absolute(py) + absolute(pz) + absolute(w) < 0x1p100f;
    const Ints beyond = ((px > w) & projection.right) | ((px < -w) & projection.left) | ((py > w) & projection.top) |
                        ((py < -w) & projection.bottom) | ((pz < 0.0f) & projection.far) | ((pz > w) & projection.near);
    const Ints somewhere = numbers & ((w > 0.0f) | (beyond != 0));
    const Floats inverse = 1.0f / w;
    const Floats columns = Lanes::fused(px * inverse, Floats{} + projection.halfWidth, Floats{} + projection.halfWidth);
    const Floats rows = Lanes::fused(py * inverse, Floats{} + projection.halfHeight, Floats{} + projection.halfHeight);
    const Floats depth = pz * inverse;
    const Ints flags = somewhere ? beyond : Ints{} + projection.unprojectable;
    for (int i = 0; i < 8; ++i) vertices[i] = {columns[i], rows[i], depth[i], uint32_t(flags[i])};
}

template <typename Lanes>
void project(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    size_t first = 0;
    for (; first + 8 <= count; first += 8) projectEight<Lanes>(projection, positions + 3 * first, vertices + first);
    if (first == count) return;
    // The last ones, among eight.
    float last[24] = {};
    RasterVertex projected[8];
    for (size_t i = 0; i < 3 * (count - first); ++i) last[i] = positions[3 * first + i];
    projectEight<Lanes>(projection, last, projected);
    for (size_t i = 0; first + i < count; ++i) vertices[first + i] = projected[i];
}

// ---- Triangles

inline Ints lower(const Ints& a, const Ints& b) { return a < b ? a : b; }
inline Ints higher(const Ints& a, const Ints& b) { return a > b ? a : b; }

/// One corner each of eight triangles.
struct EightCorners {
    Floats x, y, depth, beyond;  ///< the last one has the bits of whole numbers
};
template <typename Part>
inline void loadCorners(const Part& part, const uint16_t* places, size_t corner, EightCorners& corners) {
    HalfFloats of[8];
    for (size_t i = 0; i < 8; ++i) load(of[i], part.vertices + part.indices[3 * size_t(places[i]) + corner]);
    Floats pairs[4];
    for (size_t i = 0; i < 4; ++i) pairs[i] = __builtin_shufflevector(of[i], of[i + 4], 0, 1, 2, 3, 4, 5, 6, 7);
    const Floats xyOfEven = __builtin_shufflevector(pairs[0], pairs[2], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats xyOfOdd = __builtin_shufflevector(pairs[1], pairs[3], 0, 8, 1, 9, 4, 12, 5, 13);
    const Floats zOfEven = __builtin_shufflevector(pairs[0], pairs[2], 2, 10, 3, 11, 6, 14, 7, 15);
    const Floats zOfOdd = __builtin_shufflevector(pairs[1], pairs[3], 2, 10, 3, 11, 6, 14, 7, 15);
    corners.x = __builtin_shufflevector(xyOfEven, xyOfOdd, 0, 8, 1, 9, 4, 12, 5, 13);
    corners.y = __builtin_shufflevector(xyOfEven, xyOfOdd, 2, 10, 3, 11, 6, 14, 7, 15);
    corners.depth = __builtin_shufflevector(zOfEven, zOfOdd, 0, 8, 1, 9, 4, 12, 5, 13);
    corners.beyond = __builtin_shufflevector(zOfEven, zOfOdd, 2, 10, 3, 11, 6, 14, 7, 15);
}

/// Of corners: the places on the raster.
template <typename Lanes>
inline void snapCorners(const EightCorners (&corners)[3], Ints (&x)[3], Ints (&y)[3]) {
    for (int i = 0; i < 3; ++i) {
        x[i] = Lanes::rounded((corners[i].x - 0.5f) * float(kSubPixels));
        y[i] = Lanes::rounded((corners[i].y - 0.5f) * float(kSubPixels));
    }
}

template <typename Lanes>
void placeTriangles(const RasterPlacing& placing, uint32_t* places) {
    const Ints none{};
    int32_t bandShift = 0;
    while (1 << bandShift < placing.bandRows) ++bandShift;
    for (size_t first = 0; first < placing.count; first += 8) {
        // Counted from the first of the eight: a mesh may have more triangles than 16 bits count. The last ones are placed
        // several times.
        uint16_t of[8];
        for (size_t i = 0; i < 8; ++i) of[i] = uint16_t(first + i < placing.count ? i : placing.count - 1 - first);
        RasterPlacing eight = placing;
        eight.indices += 3 * first;
        EightCorners corners[3];
        for (size_t i = 0; i < 3; ++i) loadCorners(eight, of, i, corners[i]);
        Ints beyond[3], x[3], y[3];
        for (int i = 0; i < 3; ++i) load(beyond[i], &corners[i].beyond);
        const Ints any = beyond[0] | beyond[1] | beyond[2], all = beyond[0] & beyond[1] & beyond[2];
        snapCorners<Lanes>(corners, x, y);
        const Ints lowX = lower(lower(x[0], x[1]), x[2]), highX = higher(higher(x[0], x[1]), x[2]);
        const Ints lowY = lower(lower(y[0], y[1]), y[2]), highY = higher(higher(y[0], y[1]), y[2]);
        const Ints firstColumn = higher((lowX + (kSubPixels - 1)) >> 8, none),
                   firstRow = higher((lowY + (kSubPixels - 1)) >> 8, none);
        const Ints endColumn = lower((highX >> 8) + 1, none + placing.width),
                   endRow = lower((highY >> 8) + 1, none + placing.height);
        const Ints small = (highX - lowX <= kSmall) & (highY - lowY <= kSmall);
        const Ints area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        const Ints clockwise = area < 0;
        const Ints away = placing.front ? (placing.mirrored ? ~clockwise : clockwise) : none;
        const auto number = [&](uint32_t place) -> Ints { return none + int32_t(place); };
        Ints result = (firstRow >> bandShift) << int(kFirstBandShift) | ((endRow - 1) >> bandShift) << int(kLastBandShift);
        result = ((firstColumn >= endColumn) | (firstRow >= endRow)) ? number(kPlacedWithoutSample) : result;
        result = away ? number(kPlacedFacingAway) : result;
        result = area == 0 ? number(kPlacedWithoutSample) : result;
        result = small ? result : number(kPlacedLarge);
        result = any != 0 ? number(kPlacedBeyond) : result;
        result = ((all != 0) | ((any & placing.unprojectable) != 0)) ? number(kPlacedOutside) : result;
        store<Ints>(places + first, result);
    }
}

}  // namespace
}  // namespace cullscope
