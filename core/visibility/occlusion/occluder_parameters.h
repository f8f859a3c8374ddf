#pragma once

#include "core/visibility/parameters.h"
#include "core/visibility/strategy.h"

namespace cullscope::occlusion {

/// What the strategies that draw occluders on the processor have in common: how small an occluder's triangles may be, and how
/// many there may be.
inline constexpr const char* kOccluderPixels = "pixels";
inline constexpr const char* kOccluderTriangles = "triangles";
[[nodiscard]] ParameterDeclaration occluderPixelsParameter();
[[nodiscard]] ParameterDeclaration occluderTrianglesParameter();
[[nodiscard]] DeclaredSweep occluderPixelsSweep();
[[nodiscard]] DeclaredSweep occluderTrianglesSweep();

}  // namespace cullscope::occlusion
