#pragma once

#include <cstddef>
#include <cstdint>

#include "core/raster/screen_triangle.h"

// The interface between the occlusion buffer and its kernels, which are compiled for other instruction sets than the rest of the
// library. No inline function may be defined or included here (screen_triangle.h says why).

namespace cullscope {

/// A tile of an occlusion buffer has so many columns and rows of pixels.
inline constexpr int32_t kOcclusionColumns = 32, kOcclusionRows = 8;
/// A masked tile consists of eight blocks of 8 columns and 4 rows: four from the left to the right, and four above them.
inline constexpr int32_t kBlockColumns = 8, kBlockRows = 4, kBlocks = 8, kBlocksInRow = 4;

/// The depth of every pixel of a tile, reversed: 0 where there is nothing. Row by row from the bottom.
struct alignas(64) DepthTile {
    float depth[kOcclusionRows * kOcclusionColumns];
};

/// Of each block two depths, reversed, and a mask (Hasselgren, Andersson & Akenine-Möller 2016). Every pixel of the block shows
/// something at `whole` or nearer; those of `mask` also at `part` or nearer, which lies not behind `whole`. Bit
/// 8 · row + column of the mask: a pixel of the block.
struct alignas(32) MaskedTile {
    float whole[kBlocks];
    float part[kBlocks];
    uint32_t mask[kBlocks];
};

/// A triangle of an occluder in the picture: corners and planes as those of a ScreenTriangle.
struct OccluderTriangle {
    int32_t x[3], y[3];
    int32_t firstColumn, endColumn, firstRow, endRow;
    /// At the lower left pixel, less a bound on the rounding of all that is computed of it; and the changes by column and row.
    float depth, perColumn, perRow;
    /// No pixel of the triangle in the buffer is nearer, or farther.
    float nearest, farthest;
};

/// What makes triangles occluders: by corners that lie on the raster, three indices each.
struct OccluderSetup {
    const RasterVertex* vertices;
    const uint32_t* indices;
    size_t count;
    int32_t width, height;  ///< of the picture
    bool front, mirrored;   ///< as RasterFacing
};
/// Those of the triangles that have an area, face as the rule wants, have a pixel's centre in their box, are at least a pixel
/// wide and have a plane, in their order; returns how many. There is room for all.
using OccluderSetupKernel = size_t(const OccluderSetup& setup, OccluderTriangle* triangles);

OccluderSetupKernel setUpOccludersPortable, setUpOccludersAvx2, setUpOccludersAvx512;

/// The tiles of a picture, a row of them after the other, from the bottom. One of the two arrays is null.
struct OcclusionTiles {
    DepthTile* depths;
    /// With `depths`: of each tile the depth of its farthest pixel; kUnknownFarthest where triangles were drawn since.
    float* farthest;
    MaskedTile* masked;
    int32_t tilesInRow;
    int32_t width, height;  ///< of the picture, pixels
};
inline constexpr float kUnknownFarthest = -1.0f;

/// Draws triangles. A pixel is covered as a ScreenTriangle covers it, to the bit; its depth in the buffer is that of the
/// triangle's plane, less the bound; a masked tile keeps of each block what lies farther.
using OccluderKernel = void(const OccluderTriangle* triangles, size_t count, const OcclusionTiles& tiles);

OccluderKernel drawOccludersPortable, drawOccludersAvx2, drawOccludersAvx512;

}  // namespace cullscope
