#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace cullscope {

inline constexpr size_t kCornerBlock = 16;

/// The corners of sixteen triangles: x, y and z of the first, then of the second and third, relative to the mesh's origin. NaN
/// behind the last triangle.
struct alignas(64) CornerBlock {
    std::array<std::array<float, kCornerBlock>, 9> rows;
};

/// What the test of triangles needs of an object in a view.
struct SampleTest {
    /// A corner p is at (x · (p, 1), y · (p, 1)) / w · (p, 1), in pixels from the picture's lower left corner.
    std::array<float, 4> x{}, y{}, w{};
    float leastW = 0.0f, mostW = 0.0f;     ///< between these no near or far plane clips a triangle
    float width = 0.0f, height = 0.0f;     ///< of the picture
    float room = 0.0f, roomTimesW = 0.0f;  ///< a corner may be off by room + roomTimesW / w pixels on each side
    float front = 0.0f;  ///< 1: counter-clockwise triangles are drawn alone, −1: clockwise ones, 0: both sides are
};

/// Of the triangles of a block, bit by bit.
struct BlockVerdict {
    uint16_t facesAway = 0, holdsNoCentre = 0;  ///< no triangle is in both
};

/// One verdict for each block; the same on each level.
void testSamplesPortable(std::span<const CornerBlock> blocks, const SampleTest& test, BlockVerdict* verdicts);
void testSamplesAvx2(std::span<const CornerBlock> blocks, const SampleTest& test, BlockVerdict* verdicts);

}  // namespace cullscope
