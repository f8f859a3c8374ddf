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
/// edge, or on a horizontal edge at the bottom: then triangles that share an edge cover no pixel twice and leave none out. This
/// is the top-left rule for rows in the order of a framebuffer object's memory, whose first one is OpenGL's lowest.
struct ScreenTriangle {
    int32_t x[3];
    int32_t y[3];
    uint32_t number;  ///< of the scene's triangle, counted from 1
    /// The rows and columns of the picture that its box contains: all its pixels lie there.
    int32_t firstColumn, endColumn;
    int32_t firstRow, endRow;
    /// The reversed depth at the picture's lower left pixel, and its change from one column or row to the next. The depth of a
    /// pixel is fma(depthPerRow, row, fma(depthPerColumn, column, depth)), where fma rounds once, and at most 1: so every
    /// rasteriser gets the same bits, and the same as llvmpipe. Not a number where the plane is none: such a triangle is nowhere
    /// the nearest.
    float depth, depthPerColumn, depthPerRow;
};

/// A vertex in the picture: pixels from its lower left corner, and the reversed depth. Edges go through the corner rounded to
/// 1/256 pixel, depths through the corner as it is.
struct RasterVertex {
    float x, y;
    float depth;
    uint32_t beyond;  ///< beyond which planes it lies (Beyond, triangle_setup.h); then its place is not used
};

/// Triangles whose box has at most this size have edge functions within 32 bits. They are set up eight at a time where they are
/// drawn, from their vertices; larger ones and those that were clipped one by one, as ScreenTriangles.
inline constexpr int32_t kSmall = 64 * kSubPixels;

/// What became of a triangle in a picture made in software. No enumeration of a class: kernels store it as bytes.
enum TriangleFate : uint8_t {
    kNoSample,    ///< it covers no pixel centre of the picture
    kCovers,      ///< it covers at least one, and is behind others at all of them
    kOutside,     ///< all its corners lie beyond one plane of the frustum
    kFacingAway,  ///< the facing rule drops it
    kShown,       ///< the picture shows it
    kTriangleFates
};

/// The entry of a triangle that was set up: this and its place among them; else the triangle's place in its part.
inline constexpr uint16_t kSetUp = 0x8000;

/// Those triangles of a part that reach a band, in their order.
struct PartInBand {
    const RasterVertex* vertices;
    const uint32_t* indices;  ///< of the part's triangles, three each
    uint32_t firstNumber;     ///< of the part's first triangle
    const ScreenTriangle* setUp;
    const uint16_t* entries;
    size_t count;
};

/// Four rows of four pixels, from the bottom. A tile is a cache line of depths and one of numbers.
struct alignas(64) RasterTile {
    float depth[16];
    uint32_t number[16];
};
inline constexpr int32_t kTile = 4;

/// A band of rows of a picture that a kernel draws into, by tiles: a row of them after the other, from the bottom. Its first row
/// is a multiple of a tile's; its last tiles may reach beyond the picture, where nothing is drawn.
struct RasterBand {
    RasterTile* tiles;
    size_t tilesInRow;
    int32_t firstRow, endRow;
    int32_t width;   ///< of the picture
    uint8_t* fates;  ///< by scene triangle: kCovers is stored where a triangle covers a sample
};

/// What drawing into a band counted.
struct RasterCounts {
    uint64_t comparisons;  ///< samples whose depth was compared with the buffer's
    uint64_t written;      ///< samples that replaced what was there
};

/// Draws triangles in their order into a band: a sample is written where its depth is above the one that is there.
using RasterKernel = void(const PartInBand& part, const RasterBand& band, RasterCounts& counts);

RasterKernel drawTrianglesPortable, drawTrianglesAvx2, drawTrianglesAvx512;

/// Where a triangle lies on the raster: one of these, and, of small ones, the first and the last band that it reaches.
enum TrianglePlace : uint32_t {
    kPlacedSmall,          ///< at most kSmall wide and high
    kPlacedLarge,          ///< larger: what becomes of it is not decided yet
    kPlacedBeyond,         ///< with some corners beyond a plane of the frustum: the same
    kPlacedOutside,        ///< with all of them beyond one plane
    kPlacedFacingAway,     ///< dropped by the facing rule
    kPlacedWithoutSample,  ///< without area on the raster, or without a pixel's centre in its box
    kPlaces,
    kFirstBandShift = 4,
    kLastBandShift = 18
};
/// What places triangles, consecutive ones of a part.
struct RasterPlacing {
    const RasterVertex* vertices;
    const uint32_t* indices;  ///< three of each triangle
    size_t count;
    int32_t width, height, bandRows;  ///< of the picture; a power of two
    int32_t unprojectable;            ///< a bit of RasterVertex::beyond that a single corner suffices for
    bool front, mirrored;             ///< as RasterFacing
};
/// Gives a number for every triangle, eight at a time: `places` has room up to the next multiple of eight.
using PlacingKernel = void(const RasterPlacing& placing, uint32_t* places);

PlacingKernel placePortable, placeAvx2, placeAvx512;

/// How positions come to the raster (triangle_setup.h): clip coordinates by the columns of a matrix, then pixels.
struct RasterProjection {
    float columns[4][4];
    float halfWidth, halfHeight;
    int32_t right, left, top, bottom, far, near, unprojectable;  ///< how RasterVertex::beyond names the planes
};

/// Projects positions, three numbers each.
using ProjectionKernel = void(const RasterProjection& projection, const float* positions, size_t count, RasterVertex* vertices);

ProjectionKernel projectPortable, projectAvx2, projectAvx512;

}  // namespace cullscope
