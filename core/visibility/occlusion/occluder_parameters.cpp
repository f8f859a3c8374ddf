#include "core/visibility/occlusion/occluder_parameters.h"

#include "core/base/message.h"

namespace cullscope::occlusion {

ParameterDeclaration occluderPixelsParameter() {
    return bySize(
        {kOccluderPixels,
         ParameterType::Real,
         16.0,
         1.0,
         1e6,
         "px",
         CULLSCOPE_TR("How many pixels the triangles of an occluder have on average, seen face on: smaller ones hide little."),
         {}},
        1.0);
}

ParameterDeclaration occluderTrianglesParameter() {
    return {kOccluderTriangles,
            ParameterType::Integer,
            int64_t{100000},
            0.0,
            1e6,
            "",
            CULLSCOPE_TR("How many triangles all occluders of a frame may have together."),
            {}};
}

DeclaredSweep occluderPixelsSweep() { return {kOccluderPixels, {"4", "16", "64", "256", "1024"}}; }
DeclaredSweep occluderTrianglesSweep() { return {kOccluderTriangles, {"0", "1000", "5000", "20000", "100000"}}; }

}  // namespace cullscope::occlusion
