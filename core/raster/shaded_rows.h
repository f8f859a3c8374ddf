#pragma once

#include <cstddef>
#include <cstdint>

// The interface between the shading of pictures and its kernels, which are compiled for other instruction sets than the rest of
// the library. No inline function may be defined or included here (screen_triangle.h says why).

namespace cullscope {

/// An instance of a scene as shading needs it. Matrices are by columns.
struct ShadedInstance {
    double eye[3];            ///< in the axes of its mesh's positions
    double fromWorld[9];      ///< from world axes to those
    double forward[3];        ///< the view direction in those axes
    double ahead[3];          ///< times a vector in those axes: how far it leads along the view direction
    double normals[9];        ///< from the mesh's normals to world axes
    const float* positions;   ///< three of each vertex
    const float* normal;      ///< three of each vertex
    const uint32_t* indices;  ///< three of each triangle
    uint32_t firstTriangle;   ///< of the scene's triangles
};

/// What shading a picture needs besides its pixels.
struct Shading {
    const ShadedInstance* instances;
    size_t instanceCount;
    double forward[3], right[3], up[3];  ///< the view's basis
    double halfWidth, halfHeight;        ///< of the view at distance 1
    double width, height;                ///< of the whole picture
    double step[3];                      ///< from a pixel's place at distance 1 to that of the next one in its row
    bool parallel;                       ///< all lines of sight run forward
    float surface[3];                    ///< the colour, times 255
    uint32_t background;                 ///< as four bytes: red, green, blue, opacity
};

/// A rectangle of a picture, from its lower left pixel.
struct ShadedBlock {
    int32_t column, row;    ///< in the picture
    int32_t columns, rows;  ///< at most these
    const uint32_t* items;  ///< scene triangle numbers + 1, 0 the background
    size_t itemsInRow;      ///< from a row to the next one
    uint32_t* rgba;         ///< four bytes of each pixel
    size_t rgbaInRow;
};
inline constexpr int32_t kShadedColumns = 64, kShadedRows = 16;

/// Shades the pixels of a block.
using ShadingKernel = void(const Shading& shading, const ShadedBlock& block);

ShadingKernel shadePortable, shadeAvx2, shadeAvx512;

/// Marks the triangles that pixels show (kShown) among the fates of the scene's triangles.
using ShowingKernel = void(const uint32_t* items, size_t count, uint8_t* fates);

ShowingKernel markShownPortable, markShownAvx2, markShownAvx512;

}  // namespace cullscope
