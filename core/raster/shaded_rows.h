#pragma once

#include <cstddef>
#include <cstdint>

// The interface between the shading of pictures and its kernels, which are compiled for other instruction sets than the rest of
// the library. No inline function may be defined or included here (screen_triangle.h says why).

namespace cullscope {

/// An instance of a scene as shading needs it.
struct ShadedInstance {
    // In the axes of its mesh's positions: the eye, the view's basis, and Shading::step.
    double eye[3], forward[3], right[3], up[3], step[3];
    double normals[9];        ///< from the mesh's normals to world axes, by columns
    const float* positions;   ///< three of each vertex
    const float* normal;      ///< three of each vertex
    const uint32_t* indices;  ///< three of each triangle
    uint32_t firstTriangle;   ///< of the scene's triangles
};

/// What shading a picture needs besides its rows.
struct Shading {
    const ShadedInstance* instances;
    size_t instanceCount;
    double forward[3], right[3], up[3];  ///< the view's basis
    double tanHalfWidth, tanHalfHeight;
    double width, height;  ///< of the whole picture
    double step[3];        ///< from a pixel's direction to that of the next one in its row
    float surface[3];      ///< the colour, times 255
    uint32_t background;   ///< as four bytes: red, green, blue, opacity
};

/// Shades pixels of a row, from column `first`: `items` are scene triangle numbers + 1, 0 the background. `rgba` gets four bytes
/// of each.
using ShadingKernel = void(const Shading& shading, const uint32_t* items, int32_t count, int32_t first, int32_t row,
                           uint32_t* rgba);

ShadingKernel shadeRowPortable, shadeRowAvx2, shadeRowAvx512;

}  // namespace cullscope
