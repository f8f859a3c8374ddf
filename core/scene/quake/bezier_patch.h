#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope::quake {

/// A grid of triangles in place of curves.
struct PatchSurface {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> triangles;  ///< three corners each, in the file's winding
};

/// Into how many chords each parabola of three control points is cut.
inline constexpr uint32_t kPatchChords = 6;

/// Biquadratic Bézier patches that share their borders: `control` is a grid of `width` × `height` points row by row, both odd and
/// at least 3, of which each 3 × 3 make one patch. All corners lie on the exact surface. Two surfaces with the same control
/// points at a common border have the same corners there, also where one runs along it in the other direction.
[[nodiscard]] PatchSurface tessellatePatch(std::span<const Vec3f> control, uint32_t width, uint32_t height,
                                           uint32_t chords = kPatchChords);

}  // namespace cullscope::quake
