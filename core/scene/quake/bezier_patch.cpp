#include "core/scene/quake/bezier_patch.h"

#include <array>

namespace cullscope::quake {
namespace {

/// A parabola's place at step `i` of `chords`, times chords². The Bernstein polynomials are whole numbers here, so that those of
/// both directions are exactly the same; the sum of the ends comes first for the same reason.
Vec3 parabola(const std::array<Vec3, 3>& control, uint32_t i, uint32_t chords) {
    const double to = i, from = chords - i;
    return (from * from * control[0] + to * to * control[2]) + 2.0 * from * to * control[1];
}

}  // namespace

PatchSurface tessellatePatch(std::span<const Vec3f> control, uint32_t width, uint32_t height, uint32_t chords) {
    PatchSurface surface;
    const uint32_t columns = (width - 1) / 2 * chords, rows = (height - 1) / 2 * chords;
    const double scale = double(chords) * chords * chords * chords;
    surface.positions.reserve(size_t(columns + 1) * (rows + 1));
    for (uint32_t row = 0; row <= rows; ++row)
        for (uint32_t column = 0; column <= columns; ++column) {
            // The last row and column belong to the patch before them.
            const uint32_t top = row == rows ? height - 3 : row / chords * 2;
            const uint32_t left = column == columns ? width - 3 : column / chords * 2;
            std::array<Vec3, 3> along;
            for (uint32_t j = 0; j < 3; ++j) {
                const Vec3f* points = &control[size_t(top + j) * width + left];
                along[j] = parabola({Vec3(points[0]), Vec3(points[1]), Vec3(points[2])}, column - left / 2 * chords, chords);
            }
            surface.positions.emplace_back(parabola(along, row - top / 2 * chords, chords) / scale);
        }
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t a = row * (columns + 1) + column, b = a + columns + 1;
            surface.triangles.insert(surface.triangles.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    return surface;
}

}  // namespace cullscope::quake
