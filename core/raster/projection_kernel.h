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
    // The others, which are few, are left to Projection: before the near plane, beyond the raster's range, or no numbers.
    const Ints projected = (w > 0.0f) & (pz <= w) & (absolute(px) <= projection.rangeX * w) &
                           (absolute(py) <= projection.rangeY * w) & (absolute(px) + absolute(py) + absolute(pz) + w < 0x1p100f);
    const Ints beyond = ((px < -w) & projection.left) | ((px > w) & projection.right) | ((py < -w) & projection.bottom) |
                        ((py > w) & projection.top) | ((pz < 0.0f) & projection.far);
    const Floats inverse = 1.0f / w;
    const auto snapped = [&](const Floats& coordinate, float half) {
        const Floats pixels = coordinate * inverse * half + half;
        return Lanes::rounded((pixels - 0.5f) * float(kSubPixels));
    };
    const Ints columns = snapped(px, projection.halfWidth), rows = snapped(py, projection.halfHeight);
    const Floats depth = pz * inverse;
    for (int i = 0; i < 8; ++i)
        vertices[i] = {columns[i], rows[i], depth[i], projected[i] != 0 ? uint32_t(beyond[i]) : kNotProjected};
}

template <typename Lanes>
void project(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices) {
    size_t first = 0;
    for (; first + 8 <= count; first += 8) projectEight<Lanes>(projection, positions + 3 * first, vertices + first);
    for (; first < count; ++first) vertices[first].beyond = kNotProjected;
}

}  // namespace
}  // namespace cullscope
