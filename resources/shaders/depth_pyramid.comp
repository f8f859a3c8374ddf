#version 450
// One level of a depth pyramid: each texel is the farthest, which of reversed depths is the least, of up to 2 × 2 texels of the
// level below. A level has half the columns and rows of that one, rounded up: so texel (x, y) of level n stands for the pixels
// from (x, y) · 2^n on, at any size of the picture, and of an odd column or row the last texel has fewer below it.

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 0) uniform sampler2D depth;                        // level 0
layout(std430, binding = 0) buffer Pyramid { float pyramid[]; };    // the levels from 1 on, one after the other, row by row
layout(location = 0) uniform ivec2 belowSize;
layout(location = 1) uniform int belowStart;  // in the pyramid; below 0: level 0 is below
layout(location = 2) uniform int start;

void main() {
    ivec2 size = (belowSize + 1) / 2;
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, size))) return;
    ivec2 first = 2 * texel;
    ivec2 last = min(first + 1, belowSize - 1);
    float farthest = 1.0;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x)
            farthest = min(farthest, belowStart < 0 ? texelFetch(depth, ivec2(x, y), 0).r
                                                    : pyramid[belowStart + y * belowSize.x + x]);
    pyramid[start + texel.y * size.x + texel.x] = farthest;
}
