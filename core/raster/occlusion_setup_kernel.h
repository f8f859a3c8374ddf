#pragma once

#include "core/raster/occlusion_tiles.h"
#include "core/raster/projection_kernel.h"

// Makes triangles on the raster occluders, eight at a time. Compiled once for every instruction set, as the other kernels of the
// occlusion buffer.

namespace cullscope {
namespace {

/// Eight triangles, an element each.
struct EightOccluders {
    Ints x[3], y[3];
    Ints firstColumn, endColumn, firstRow, endRow;
    Floats depth, perColumn, perRow, nearest, farthest;
};

/// What the least width of eight triangles in the picture follows from.
struct EightShapes {
    EightDoubles twiceArea;  ///< square pixels; above 0 in counter-clockwise order
    EightDoubles longest;    ///< edge, squared
};

inline void shapesOf(const Ints (&x)[3], const Ints (&y)[3], EightShapes& shapes) {
    constexpr double kPixel = 1.0 / kSubPixels;
    EightDoubles dx[3], dy[3];  // whole numbers of 1/256 pixel: their products and differences are exact
    shapes.longest = EightDoubles{};
    for (int i = 0; i < 3; ++i) {
        const int next = i == 2 ? 0 : i + 1;
        dx[i] = __builtin_convertvector(x[next] - x[i], EightDoubles) * kPixel;
        dy[i] = __builtin_convertvector(y[next] - y[i], EightDoubles) * kPixel;
        const EightDoubles squared = dx[i] * dx[i] + dy[i] * dy[i];
        shapes.longest = shapes.longest < squared ? squared : shapes.longest;
    }
    shapes.twiceArea = dx[2] * dy[0] - dx[0] * dy[2];
}

/// The planes of depth through the corners as they are, as screenTriangle computes them; `turned`: given clockwise.
inline void planesOf(const EightCorners (&corners)[3], const Ints& turned, EightOccluders& result) {
    const Floats px = turned ? corners[0].x : corners[1].x, py = turned ? corners[0].y : corners[1].y,
                 pDepth = turned ? corners[0].depth : corners[1].depth;
    const Floats qx = turned ? corners[1].x : corners[0].x, qy = turned ? corners[1].y : corners[0].y,
                 qDepth = turned ? corners[1].depth : corners[0].depth;
    const Floats xToP = px - qx, yToP = py - qy, xToR = corners[2].x - px, yToR = corners[2].y - py;
    const Floats toPlane = 1.0f / (xToP * yToR - yToP * xToR);
    const Floats xToPScaled = xToP * toPlane, yToPScaled = yToP * toPlane, xToRScaled = xToR * toPlane,
                 yToRScaled = yToR * toPlane;
    const Floats depthToP = pDepth - qDepth, depthToR = corners[2].depth - pDepth;
    result.perColumn = depthToP * yToRScaled - depthToR * yToPScaled;
    result.perRow = depthToR * xToPScaled - depthToP * xToRScaled;
    result.depth = pDepth - (result.perColumn * (px - 0.5f) + result.perRow * (py - 0.5f));
}

/// Pushes depths back by a bound on their rounding, and finds each triangle's nearest and farthest. Returns where these are
/// numbers.
///
/// The rounding of its depths: a plane is computed from three corners by products and one division, and evaluated from the lower
/// left pixel. Each step rounds by 2^-24 of its terms, which are at most |depth| + |perColumn| · width + |perRow| · height; the
/// division's dividend is a difference of products up to the square of the longest edge, so that its relative rounding is
/// multiplied by that square over the area. Four such roundings are subtracted.
inline void boundDepths(const OccluderSetup& setup, const EightShapes& shapes, EightOccluders& result, Ints& numbers) {
    constexpr double kPixel = 1.0 / kSubPixels, kInfinite = __builtin_inf();
    const auto wide = [](const Floats& values, EightDoubles& doubles) {
        doubles = __builtin_convertvector(values, EightDoubles);
    };
    const auto absolute = [](const EightDoubles& values, EightDoubles& positive) { positive = values < 0.0 ? -values : values; };
    EightDoubles depth, perColumn, perRow, ofDepth, ofColumn, ofRow;
    wide(result.depth, depth);
    wide(result.perColumn, perColumn);
    wide(result.perRow, perRow);
    absolute(depth, ofDepth);
    absolute(perColumn, ofColumn);
    absolute(perRow, ofRow);
    const EightDoubles terms = ofDepth + ofColumn * double(setup.width) + ofRow * double(setup.height);
    const EightDoubles rounding = 0x1p-22 * terms * (1.0 + 2.0 * shapes.longest / shapes.twiceArea);
    depth -= rounding;
    EightDoubles farthest = EightDoubles{} + kInfinite, nearest = -farthest;
    for (int i = 0; i < 3; ++i) {
        const EightDoubles x = __builtin_convertvector(result.x[i], EightDoubles),
                           y = __builtin_convertvector(result.y[i], EightDoubles);
        const EightDoubles ofCorner = depth + kPixel * (x * perColumn + y * perRow);
        farthest = ofCorner < farthest ? ofCorner : farthest;
        nearest = nearest < ofCorner ? ofCorner : nearest;
    }
    // The pixels' centres lie within the rounded corners, the plane's corners up to 1/256 pixel elsewhere.
    const EightDoubles elsewhere = kPixel * (ofColumn + ofRow) + rounding;
    farthest -= elsewhere;
    nearest += elsewhere;
    const EightDoubles finite = ((farthest > -kInfinite) & (farthest < kInfinite)) ? EightDoubles{} + 1.0 : EightDoubles{};
    numbers = __builtin_convertvector(finite, Ints) != 0;
    result.depth = __builtin_convertvector(depth, Floats);
    result.nearest = __builtin_convertvector(nearest, Floats);
    result.farthest = __builtin_convertvector(farthest, Floats);
}

/// Sets up the eight triangles of 24 corners. A bit of the result: the triangle is an occluder.
template <typename Lanes>
uint32_t setUpEight(const OccluderSetup& setup, const uint32_t* indices, EightOccluders& result) {
    const uint16_t inOrder[8] = {0, 1, 2, 3, 4, 5, 6, 7};
    const OccluderSetup eight{setup.vertices, indices, 8, setup.width, setup.height, setup.front, setup.mirrored};
    EightCorners corners[3];
    for (size_t i = 0; i < 3; ++i) loadCorners(eight, inOrder, i, corners[i]);
    Ints x[3], y[3];
    snapCorners<Lanes>(corners, x, y);
    EightShapes shapes;
    shapesOf(x, y, shapes);
    const EightDoubles negative = shapes.twiceArea < 0.0 ? EightDoubles{} + 1.0 : EightDoubles{};
    const Ints turned = __builtin_convertvector(negative, Ints) != 0;
    result.x[0] = x[0];
    result.x[1] = turned ? x[2] : x[1];
    result.x[2] = turned ? x[1] : x[2];
    result.y[0] = y[0];
    result.y[1] = turned ? y[2] : y[1];
    result.y[2] = turned ? y[1] : y[2];
    shapes.twiceArea = shapes.twiceArea < 0.0 ? -shapes.twiceArea : shapes.twiceArea;
    const Ints none{};
    result.firstColumn = higher((lower(lower(x[0], x[1]), x[2]) + (kSubPixels - 1)) >> 8, none);
    result.endColumn = lower((higher(higher(x[0], x[1]), x[2]) >> 8) + 1, none + setup.width);
    result.firstRow = higher((lower(lower(y[0], y[1]), y[2]) + (kSubPixels - 1)) >> 8, none);
    result.endRow = lower((higher(higher(y[0], y[1]), y[2]) >> 8) + 1, none + setup.height);
    planesOf(corners, turned, result);
    // The height over the longest edge is the least width; without an area there is none.
    const EightDoubles aPixelWide = ((shapes.twiceArea > 0.0) & (shapes.twiceArea * shapes.twiceArea >= shapes.longest))
                                        ? EightDoubles{} + 1.0
                                        : EightDoubles{};
    Ints numbers;
    boundDepths(setup, shapes, result, numbers);
    const Ints away = setup.front ? (setup.mirrored ? ~turned : turned) : none;
    return Lanes::bitsOf((__builtin_convertvector(aPixelWide, Ints) != 0) & numbers & ~away &
                         (result.firstColumn < result.endColumn) & (result.firstRow < result.endRow));
}

template <typename Lanes>
size_t setUpOccluders(const OccluderSetup& setup, OccluderTriangle* triangles) {
    size_t made = 0;
    for (size_t first = 0; first < setup.count; first += 8) {
        const size_t count = setup.count - first < 8 ? setup.count - first : 8;
        uint32_t last[24];
        const uint32_t* indices = setup.indices + 3 * first;
        if (count < 8) {
            // The last one is set up several times.
            for (size_t i = 0; i < 24; ++i) last[i] = indices[3 * (i / 3 < count ? i / 3 : count - 1) + i % 3];
            indices = last;
        }
        EightOccluders eight;
        uint32_t occluders = setUpEight<Lanes>(setup, indices, eight) & ((1u << count) - 1u);
        for (; occluders != 0; occluders &= occluders - 1) {
            const int i = __builtin_ctz(occluders);
            triangles[made++] = {{eight.x[0][i], eight.x[1][i], eight.x[2][i]},
                                 {eight.y[0][i], eight.y[1][i], eight.y[2][i]},
                                 eight.firstColumn[i],
                                 eight.endColumn[i],
                                 eight.firstRow[i],
                                 eight.endRow[i],
                                 eight.depth[i],
                                 eight.perColumn[i],
                                 eight.perRow[i],
                                 eight.nearest[i],
                                 eight.farthest[i]};
        }
    }
    return made;
}

}  // namespace
}  // namespace cullscope
