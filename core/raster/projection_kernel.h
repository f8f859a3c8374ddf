#pragma once

#include "core/raster/screen_triangle.h"
#include "core/raster/vectors.h"

// Brings vertices to the raster, eight at a time, as Projection does one. Compiled once for every instruction set, as the depth
// buffer's kernels.

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
    const Ints flags = somewhere ? beyond : Ints{} + projection.nowhere;
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

}  // namespace
}  // namespace cullscope
