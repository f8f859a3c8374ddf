#pragma once

#include <cstddef>
#include <cstdint>

// The interface between the rasterisers and the kernels of the depth buffer, which are compiled for other instruction sets than
// the rest of the library. No inline function may be defined or included here: the linker keeps one copy, possibly one that not
// every processor can run.

namespace cullscope {

/// Corners are rounded to this fraction of a pixel, as software OpenGL and most hardware do.
inline constexpr int32_t kSubPixels = 256;

/// A triangle on the raster of a picture. Its corners are whole numbers of 1/256 pixel, counted from the centre of the first
/// pixel (rows from the bottom), in counter-clockwise order. A pixel belongs to it where its centre lies inside, or on a left
/// edge, or on a horizontal edge at the top: then triangles that share an edge cover no pixel twice and leave none out.
struct ScreenTriangle {
    int32_t x[3];
    int32_t y[3];
    uint32_t number;  ///< of the scene's triangle, counted from 1
    /// The rows and columns of the picture that its box contains: all its pixels lie there.
    int32_t firstColumn, endColumn;
    int32_t firstRow, endRow;
    /// The reversed depth at the first column and row, and its change from one column or row to the next. The depth of a pixel
    /// is float((depth + depthPerRow · rows) + depthPerColumn · columns), in this order and in double precision: so every
    /// rasteriser gets the same bits.
    double depth, depthPerColumn, depthPerRow;
};

/// A band of rows of a picture that a kernel draws into. Each row has `stride` elements, a multiple of kLanes, so that the last
/// pixels of a row are not a special case.
struct RasterBand {
    float* depth;
    uint32_t* number;
    size_t stride;
    int32_t firstRow, endRow;
};
inline constexpr int32_t kLanes = 8;

/// What drawing into a band counted.
struct RasterCounts {
    uint64_t comparisons;  ///< samples whose depth was compared with the buffer's
    uint64_t written;      ///< samples that replaced what was there
};

/// Draws triangles in their order into a band: a sample is written where its depth is above the one that is there.
using RasterKernel = void(const ScreenTriangle* const* triangles, size_t count, const RasterBand& band, RasterCounts& counts);

RasterKernel drawTrianglesPortable, drawTrianglesAvx2;

}  // namespace cullscope
